#pragma once
// A compiled scene: immutable, complete, and without anything that the scene does not use.
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shading/light_sample.h"
#include "shading/phong.h"
#include "shading/texture_lookup.h"
#include "trace/camera.h"
#include "trace/motion_group.h"

namespace rayscope::trace {

/// A material as the tracer reads it.
struct SurfaceMaterial {
    glm::dvec3 kd, ks;
    double shininess = 1.0, opacity = 1.0;
    bool reflects = false;                         ///< spawns mirror rays
    const shading::MipTexture* texture = nullptr;  ///< replaces kd
};

/// Geometry with its search structure.
struct MotionGroup {
    std::shared_ptr<const Geometry> geometry;
    std::shared_ptr<const Accel> accel;
    std::uint32_t firstPrimitive =
        0;  ///< number of the motionGroup's first primitive among those of the world
};

/// A light and the number of samples that it takes where it is sampled in full.
struct CompiledLight {
    Light light;
    shading::LightSampleGrid grid;
    int dimensions = 0;  ///< of its shape: 0 point, 1 segment, 2 parallelogram
    bool castsShadows = true;
};

/// Where a primitive of the world comes from.
struct PrimitiveLocation {
    const MotionGroup* motionGroup = nullptr;
    const ObjectRange* range = nullptr;
    std::uint32_t inGroup = 0;   ///< number within the motionGroup
    std::uint32_t inObject = 0;  ///< number of the triangle within its mesh
};

/// Everything that radiance is a function of, besides the seed and the name of the sample.
class World {
  public:
    std::shared_ptr<const SceneDescription> description;
    Settings settings;
    std::vector<MotionGroup> motionGroups;
    std::vector<SurfaceMaterial> materials;
    std::vector<std::shared_ptr<const shading::MipTexture>> textures;
    std::vector<CompiledLight> lights;
    std::shared_ptr<const Environment> environment;  ///< null if the scene has none or it is switched off
    Camera camera;
    int width = 1, height = 1;
    bool moves = false;              ///< some motionGroup has a motion
    bool attenuatesShadows = false;  ///< shadow rays must look at what they cross
    double buildSeconds = 0.0;       ///< time spent in building or refitting hierarchies for this world
    double sahCostGrowth = 1.0;  ///< what refits cost rays: most AccelSummary::costGrowth of the motionGroups

    /// The nearest hit among all motionGroups at the given time in [0, 1); of equal distances the smaller
    /// primitive number.
    bool closestHit(const Ray& ray, float time, Hit& hit) const;
    bool anyHit(const Ray& ray, float time) const;
    /// The same answers for many rays at once; a ray that hits nothing gets a Hit without a primitive.
    void closestHits(std::span<const Ray> rays, float time, std::span<Hit> hits) const;
    void anyHits(std::span<const Ray> rays, float time, std::span<std::uint8_t> occluded) const;

    /// Whether a shadow ray is one question of yes or no, the same at all times.
    bool canDeferShadowRays() const { return !attenuatesShadows && !moves; }

    PrimitiveLocation nameOf(std::uint32_t primitive) const;
    std::uint32_t materialOf(const PrimitiveLocation& name) const;
    std::uint32_t primitiveCount() const;
};

}  // namespace rayscope::trace
