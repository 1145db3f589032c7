#include "trace/term_queue.h"

#include <array>

#include "trace/world.h"

namespace rayscope::trace {

TermQueue::TermQueue(const World& world) : world_(world) {
    terms_.reserve(kMostTerms);
    shadows_.reserve(kMostTerms);
}

void TermQueue::fold() {
    std::array<std::uint8_t, kMostTerms> occluded;
    world_.anyHits(shadows_, 0.0f, {occluded.data(), shadows_.size()});
    for (const Term& term : terms_)
        if (term.shadow == kNoShadow || !occluded[term.shadow]) results_[term.sample].radiance += term.value;
    terms_.clear();
    shadows_.clear();
}

}  // namespace rayscope::trace
