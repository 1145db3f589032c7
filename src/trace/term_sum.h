#pragma once
#include <rayscope/vector.h>

#include <concepts>

#include "trace/path_observer.h"

namespace rayscope::trace {

/// The radiance of one sample; each term is added at once.
struct TermSum {
    static constexpr bool kDefersShadowRays = false;

    RgbSum sum{0.0};
    void add(const glm::dvec3& term) { sum += term; }
};

/// Accumulators of a tracer with observer O. One that defers shadow rays does not know the visibility of a
/// light sample while the path is traced, so there would be nothing to report: it needs the NullObserver.
template <class Terms, class O>
concept TermsFor = PathObserver<O> &&
    (!Terms::kDefersShadowRays || std::same_as<O, NullObserver>)&&requires(Terms& terms,
                                                                           const glm::dvec3& term) {
    terms.add(term);
};

}  // namespace rayscope::trace
