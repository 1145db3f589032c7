#pragma once
#include <rayscope/vector.h>

namespace rayscope::trace {

/// The radiance of one sample, each term added as it is found.
struct TermSum {
    static constexpr bool kDefersShadowRays = false;

    RgbSum sum{0.0};
    void add(const glm::dvec3& term) { sum += term; }
};

}  // namespace rayscope::trace
