#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

namespace rayscope::base {

/// A number for JSON, which knows neither infinity nor NaN: null in their place.
inline nlohmann::json numberOrNull(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace rayscope::base
