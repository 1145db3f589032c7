#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>

#include <string>
#include <string_view>
#include <vector>

namespace rayscope::measure {

/// The settings that combinations treat specially.
enum class ParameterMeaning {
    SamplesPerPixel,
    SplitCount,  ///< number of samples, of a light, a lens or a reflection, per pixel sample
    MaxDepth,
    Other
};

/// A setting with an effect on time or error, and the values to measure, in increasing order.
struct Parameter {
    std::string key;
    ParameterMeaning meaning = ParameterMeaning::Other;
    std::vector<std::string> levels;
};

/// The parameters with an effect in this scene under these settings. Numbers take their present value and
/// powers of two (and 0 where it is allowed) up to 64; samples per pixel up to 4096.
std::vector<Parameter> parametersOf(const SceneRequirements& scene, const Settings& settings);

/// The effects that can be switched on or off.
struct Effect {
    std::string_view key, label;
    bool on = false;
    std::string reason;  ///< why switching it cannot change the picture; empty if none is known
};
std::vector<Effect> effectsOf(const SceneRequirements& scene, const Settings& settings);

}  // namespace rayscope::measure
