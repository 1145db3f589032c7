#pragma once
#include <rayscope/trade.h>

#include <chrono>
#include <random>

#include "measure/trade/reference_image.h"
#include "measure/trade/timed_render.h"

namespace rayscope::measure {

/// The measurements of one candidate, an entry per block unless stated otherwise.
struct CandidateRuns {
    std::vector<double> seconds, buildSeconds, squaredErrors, flips;
    std::vector<double> squaredBiases, squaredNoises;  ///< an entry per pair of blocks (0, 1), (2, 3) …
    std::vector<std::string> imageHashes;
    RgbImage previous;  ///< picture of the first block of an unfinished pair
    TradeWork work;
    bool dropped = false;  ///< not measured: too slow for the budget
};

/// The study behind measureTrade(). A pilot measures the speed of the machine; half of the budget is spent on
/// the reference, the rest on blocks. In each block every candidate is rendered once, in random order and
/// with the seed of the block, so that changes in machine load affect all candidates alike.
class TradeStudy {
  public:
    explicit TradeStudy(const TradeRequest& request);
    TradeResult run();

  private:
    bool pilot();
    void loadReference(const std::string& file);
    void buildReference();
    void firstBlock();
    void laterBlocks();
    bool measure(std::size_t index, int block, double maxSeconds);
    TradeWork workOf(const TimedRender& timed) const;
    void measureErrors(const TimedRender& timed, CandidateRuns& runs, int block);
    trace::CompileRequest compileRequest(const Settings& settings) const;
    double elapsed() const;
    bool stopped() const { return request_.stop.stop_requested(); }
    void reportProgress(const std::string& phase) const;

    const TradeRequest& request_;
    render::ThreadArena workers_;
    std::chrono::steady_clock::time_point start_;
    std::shared_ptr<const trace::World> world_;
    std::unique_ptr<ReferenceImage> reference_;
    RgbImage halfA_, halfB_, mean_;
    Settings base_;
    double maxSeconds_ = 0.0;  ///< of one picture; a slower one would be too accurate for the reference
    std::vector<CandidateRuns> runs_;
    TradeResult result_;
};

/// Computes the statistics of all points from their runs, and from these the Pareto front, advice, effects,
/// presets, break-evens and remarks. `runs` corresponds to `result.points`.
void summarizeTrade(TradeResult& result, const std::vector<CandidateRuns>& runs,
                    const SceneRequirements& scene);

}  // namespace rayscope::measure
