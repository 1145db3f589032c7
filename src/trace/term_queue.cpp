#include "trace/term_queue.h"

#include <array>

#include "trace/world.h"

namespace rayscope::trace {

TermQueue::TermQueue(const World& world) : world_(world) {
    terms_.reserve(kMaxTerms);
    shadows_.reserve(kMaxTerms);
}

void TermQueue::fold() {
    std::array<std::uint8_t, kMaxTerms> occluded;
    world_.anyHits(shadows_, 0.0f, {occluded.data(), shadows_.size()});
    for (const Term& term : terms_)
        if (term.shadow == kNoShadowRay || !occluded[term.shadow])
            results_[term.sample].radiance += term.value;
    terms_.clear();
    shadows_.clear();
}

}  // namespace rayscope::trace
