#pragma once
#include <rayscope/ray.h>

#include <cstdint>
#include <span>
#include <vector>

#include "trace/radiance.h"

namespace rayscope::trace {

/// The terms of many samples, of which some wait for the answer to a shadow ray, so that many shadow rays can
/// be asked at once. What a sample sums up to is the left fold of its terms all the same. For worlds at rest.
class TermQueue {
  public:
    static constexpr bool kDefersShadowRays = true;

    explicit TermQueue(const World& world);

    /// From now on terms are added to the radiance of these.
    void start(std::span<SampleResult> results) { results_ = results; }
    /// Terms now belong to this sample.
    void beginSample(std::size_t sample) { sample_ = static_cast<std::uint32_t>(sample); }
    void add(const glm::dvec3& term) { push(term, kNoShadowRay); }
    void addIfVisible(const glm::dvec3& term, const Ray& shadow) {
        shadows_.push_back(shadow);
        push(term, static_cast<std::uint32_t>(shadows_.size() - 1));
    }
    /// Asks all shadow rays and adds what is visible to the results.
    void fold();

  private:
    static constexpr std::uint32_t kNoShadowRay = 0xffffffffu;
    static constexpr std::size_t kMaxTerms = 1024;
    struct Term {
        glm::dvec3 value;
        std::uint32_t sample, shadow;
    };
    void push(const glm::dvec3& value, std::uint32_t shadow) {
        terms_.push_back({value, sample_, shadow});
        if (terms_.size() == kMaxTerms) fold();
    }

    const World& world_;
    std::span<SampleResult> results_;
    std::vector<Term> terms_;
    std::vector<Ray> shadows_;
    std::uint32_t sample_ = 0;
};

}  // namespace rayscope::trace
