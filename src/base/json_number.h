#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

namespace rayscope::base {

/// A JSON number, or null for infinity and NaN, which JSON does not have.
inline nlohmann::json numberOrNull(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace rayscope::base
