#pragma once
#include <rayscope/vector.h>

#include <concepts>

#include "trace/path_observer.h"

namespace rayscope::trace {

/// The radiance of one sample; each term is added at once.
struct TermSum {
    static constexpr bool kDefersRays = false;

    RgbSum sum{0.0};
    void add(const glm::dvec3& term) { sum += term; }
};

/// Accumulators of a tracer with observer O. If they defer rays, the visibility of a light sample is unknown
/// while the path is traced and cannot be reported, and paths are followed in parts, so only the NullObserver
/// is allowed.
template <class Terms, class O>
concept TermsFor = PathObserver<O> &&
    (!Terms::kDefersRays || std::same_as<O, NullObserver>)&&requires(Terms& terms, const glm::dvec3& term) {
    terms.add(term);
};

}  // namespace rayscope::trace
