#pragma once
// A compiled scene: immutable, complete, and without anything that the scene does not use.
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <memory>
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
    bool reflects = false;                         ///< spawns reflection rays
    const shading::MipTexture* texture = nullptr;  ///< replaces kd
};

/// The primitives of one motion with their BVH.
struct MotionGroup {
    std::shared_ptr<const Geometry> geometry;
    std::shared_ptr<const Accel> accel;  ///< null with bvh=false
    std::uint32_t firstPrimitive = 0;    ///< number of the group's first primitive within the world
};

/// A light with its sample counts.
struct CompiledLight {
    Light light;
    shading::LightSampleGrid grid;
    int dimensions = 0;  ///< of its shape: 0 point, 1 segment, 2 parallelogram
    bool castsShadows = true;
};

/// The object that a primitive of the world belongs to.
struct PrimitiveLocation {
    const MotionGroup* motionGroup = nullptr;
    const ObjectRange* range = nullptr;
    std::uint32_t inGroup = 0;   ///< number of the primitive within the motion group
    std::uint32_t inObject = 0;  ///< number of the triangle within its mesh
};

/// How the BVHs of a world were made.
struct BuildReport {
    /// Spent on building or refitting its BVHs, also if they are those of the previous world.
    double seconds = 0.0;
    double sahCostGrowth = 1.0;  ///< largest AccelSummary::costGrowth of the motion groups
};

/// Everything that radiance is a function of, besides the seed and the sample, and a report on the build.
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
    bool moves = false;              ///< some motion group has a motion
    bool attenuatesShadows = false;  ///< shadow rays need the opacity of the surfaces that they cross
    bool hasSlowRays = false;  ///< each ray tests so many primitives that it takes a millisecond or more

    BuildReport buildReport;  ///< no input of the radiance

    /// The closest hit among all motion groups at the given time in [0, 1); of equal distances the smaller
    /// primitive number.
    bool closestHit(const Ray& ray, float time, Hit& hit) const;
    bool anyHit(const Ray& ray, float time) const;
    /// The same results for many rays; a miss gets a default Hit. Both spans have the same length.
    void closestHits(std::span<const Ray> rays, float time, std::span<Hit> hits) const;
    void anyHits(std::span<const Ray> rays, float time, std::span<std::uint8_t> occluded) const;

    /// Replaces `found` with all hits of the ray, as Accel::crossings().
    void crossings(const Ray& ray, float time, std::vector<Hit>& found) const;

    /// Whether a shadow ray is a single any-hit query whose result does not depend on time.
    bool canDeferShadowRays() const { return !attenuatesShadows && !moves; }

    PrimitiveLocation locatePrimitive(std::uint32_t primitive) const;
    std::uint32_t materialOf(const PrimitiveLocation& location) const;
    std::uint32_t primitiveCount() const;
};

}  // namespace rayscope::trace
