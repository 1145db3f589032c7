#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>

#include <string>
#include <string_view>
#include <vector>

namespace rayscope::measure {

/// A setting that trades, and the values worth measuring, from the smallest number up.
struct Parameter {
    std::string key;
    Trade trade = Trade::Noise;
    bool splits = false;  ///< a number of samples within each sample of a pixel
    std::vector<std::string> levels;
};

/// The knobs that can matter in this scene under these settings. Numbers take powers of two (and 0 where it
/// is allowed) up to 64 beside their present value; samples per pixel up to 4096.
std::vector<Parameter> parametersOf(const SceneRequirements& scene, const Settings& settings);

/// The effects that can be switched on or off.
struct Effect {
    std::string_view key, label;
    bool on = false;
    std::string reason;  ///< why switching it changes nothing, or empty
};
std::vector<Effect> effectsOf(const SceneRequirements& scene, const Settings& settings);

}  // namespace rayscope::measure
