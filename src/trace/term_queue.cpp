#include "trace/term_queue.h"

#include <array>

#include "trace/world.h"

namespace rayscope::trace {

TermQueue::TermQueue(const World& world, const std::stop_token& stop)
    : world_(world), stop_(stop), maxTerms_(world.hasSlowRays ? 1 : kMaxTerms) {
    terms_.reserve(maxTerms_);
    shadows_.reserve(maxTerms_);
}

void TermQueue::fold() {
    if (!stop_.stop_requested()) {
        std::array<std::uint8_t, kMaxTerms> occluded;
        world_.anyHits(shadows_, 0.0f, {occluded.data(), shadows_.size()});
        for (const Term& term : terms_)
            if (term.shadow == kNoShadowRay || !occluded[term.shadow])
                results_[term.sample].radiance += term.value;
    }
    terms_.clear();
    shadows_.clear();
}

}  // namespace rayscope::trace
