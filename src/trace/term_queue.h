#pragma once
#include <rayscope/ray.h>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "trace/pending_path.h"
#include "trace/radiance.h"

namespace rayscope::trace {

/// The terms of many samples, some of which depend on a shadow ray, so that shadow rays are traced as one
/// batch, and the paths that continue in the next wave. The radiance of each sample remains the left fold of
/// its terms. Shadow rays only in worlds with canDeferShadowRays().
class TermQueue {
  public:
    static constexpr bool kDefersRays = true;

    /// The token must outlive the queue. After a stop request terms are dropped.
    TermQueue(const World& world, const std::stop_token& stop);

    /// Sets the results whose radiance the following terms are added to.
    void start(std::span<SampleResult> results) {
        results_ = results;
        paths_.clear();
    }
    /// Sets the sample, an index into the results, that the following terms belong to.
    void beginSample(std::size_t sample) { sample_ = static_cast<std::uint32_t>(sample); }
    void add(const glm::dvec3& term) { push(term, kNoShadowRay); }
    void addIfVisible(const glm::dvec3& term, const Ray& shadow) {
        shadows_.push_back(shadow);
        push(term, static_cast<std::uint32_t>(shadows_.size() - 1));
    }
    /// Makes room for so many paths.
    void reservePaths(std::size_t count) { paths_.reserve(count); }
    /// A path of the next wave; all further terms of its sample come from it.
    void addPath(const Segment& segment, const PathBranch& branch, std::uint32_t layer) {
        paths_.push_back({segment, branch, layer, sample_});
    }
    /// Replaces `paths` with those added since the last call.
    void takePaths(std::vector<PendingPath>& paths) {
        paths.clear();
        paths.swap(paths_);
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
    std::vector<PendingPath> paths_;
    std::uint32_t sample_ = 0;
};

}  // namespace rayscope::trace
