// Settings without effect in a scene, because it does not contain what they apply to.
#include <rayscope/scene.h>

namespace rayscope {

namespace {

struct Dependence {
    std::string_view key;
    bool SceneRequirements::*needs;
    std::string_view reason;  ///< why there is no effect otherwise
};

constexpr std::string_view kNoPoint = "the scene has no point light";
constexpr std::string_view kNoSegment = "the scene has no segment light";
constexpr std::string_view kNoParallelogram = "the scene has no parallelogram light";
constexpr std::string_view kNoReflection = "no material of the scene has ks above 0";
constexpr std::string_view kOpaque = "all materials of the scene are opaque";
constexpr std::string_view kNoTexture = "no material of the scene has a texture";
constexpr std::string_view kNoEnvironment = "the scene has no environment";
constexpr std::string_view kNoLens = "no camera of the scene has a lens";

constexpr Dependence kDependences[] = {
    {"hard_shadows", &SceneRequirements::pointLights, kNoPoint},
    {"segment_samples", &SceneRequirements::segmentLights, kNoSegment},
    {"parallelogram_samples", &SceneRequirements::parallelogramLights, kNoParallelogram},
    {"transparent_shadows", &SceneRequirements::transparency, kOpaque},
    {"recursion", &SceneRequirements::reflections, kNoReflection},
    {"max_depth", &SceneRequirements::reflections, kNoReflection},
    {"reflect_when", &SceneRequirements::reflections, kNoReflection},
    {"glossy", &SceneRequirements::reflections, kNoReflection},
    {"glossy_sigma", &SceneRequirements::reflections, kNoReflection},
    {"glossy_samples", &SceneRequirements::reflections, kNoReflection},
    {"normal_interpolation", &SceneRequirements::smoothNormals, "no mesh of the scene has vertex normals"},
    {"transparency", &SceneRequirements::transparency, kOpaque},
    {"texture_mapping", &SceneRequirements::textures, kNoTexture},
    {"texture_filter", &SceneRequirements::textures, kNoTexture},
    {"environment", &SceneRequirements::environment, kNoEnvironment},
    {"reflection_map", &SceneRequirements::environment, kNoEnvironment},
    {"depth_of_field", &SceneRequirements::lens, kNoLens},
    {"lens_samples", &SceneRequirements::lens, kNoLens},
    {"lens_shape", &SceneRequirements::lens, kNoLens},
    {"sharp_zone", &SceneRequirements::lens, kNoLens},
    {"motion_blur", &SceneRequirements::motion, "no object of the scene moves"},
};

}  // namespace

std::string_view inactiveReason(const SceneRequirements& scene, std::string_view setting) {
    const bool areaLights = scene.segmentLights || scene.parallelogramLights;
    if ((setting == "soft_shadows" || setting == "light_sample_count") && !areaLights)
        return "the scene has no segment or parallelogram light";
    for (const Dependence& dependence : kDependences)
        if (dependence.key == setting && !(scene.*dependence.needs)) return dependence.reason;
    return {};
}

}  // namespace rayscope
