#pragma once
#include <rayscope/ray.h>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "trace/radiance.h"

namespace rayscope::trace {

/// The terms of many samples, some of which depend on a shadow ray, so that shadow rays are traced as one
/// batch. The radiance of each sample remains the left fold of its terms. Only for worlds with
/// canDeferShadowRays().
class TermQueue {
  public:
    static constexpr bool kDefersShadowRays = true;

    /// The token must outlive the queue. After a stop request terms are dropped.
    TermQueue(const World& world, const std::stop_token& stop);

    /// Sets the results whose radiance the following terms are added to.
    void start(std::span<SampleResult> results) { results_ = results; }
    /// Sets the sample, an index into the results, that the following terms belong to.
    void beginSample(std::size_t sample) { sample_ = static_cast<std::uint32_t>(sample); }
    void add(const glm::dvec3& term) { push(term, kNoShadowRay); }
    void addIfVisible(const glm::dvec3& term, const Ray& shadow) {
        shadows_.push_back(shadow);
        push(term, static_cast<std::uint32_t>(shadows_.size() - 1));
    }
    /// Traces all shadow rays and adds the terms that are not occluded to the results.
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
        if (terms_.size() == maxTerms_) fold();
    }

    const World& world_;
    const std::stop_token& stop_;
    std::size_t maxTerms_;
    std::span<SampleResult> results_;
    std::vector<Term> terms_;
    std::vector<Ray> shadows_;
    std::uint32_t sample_ = 0;
};

}  // namespace rayscope::trace
