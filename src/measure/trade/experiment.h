#pragma once
#include <rayscope/trade.h>

#include <chrono>
#include <random>

#include "measure/trade/reference.h"
#include "measure/trade/trial.h"

namespace rayscope::measure {

/// What was measured of one candidate; entry b of each list is of block b.
struct CandidateRuns {
    std::vector<double> seconds, buildSeconds, squaredErrors, flips;
    std::vector<double> common, squaredNoise;  ///< of blocks (0, 1), (2, 3) …: squared bias, squared noise
    std::vector<std::uint64_t> pictures;       ///< hash of each picture
    RgbImage previous;                         ///< of the block before, until its pair is there
    TradeWork work;
    bool dropped = false;
};

/// The course of a measurement: a pilot finds out what the budget can buy, half of it goes into the
/// reference, the rest into blocks. In each block every candidate renders once, in random order and with the
/// seed of the block, so that slow phases of the machine meet all alike.
class Experiment {
  public:
    explicit Experiment(const TradeRequest& request);
    TradeResult run();

  private:
    bool pilot();
    void buildReference();
    void firstBlock();
    void laterBlocks();
    bool measure(std::size_t index, int block, double maxSeconds);
    TradeWork workOf(const Trial& trial) const;
    void judge(const Trial& trial, CandidateRuns& runs, int block);
    trace::CompileRequest compileRequest(const Settings& settings) const;
    double elapsed() const;
    bool stopped() const { return request_.stop.stop_requested(); }
    void report(const std::string& phase) const;

    const TradeRequest& request_;
    Workers workers_;
    std::chrono::steady_clock::time_point start_;
    std::shared_ptr<const trace::World> world_;
    std::unique_ptr<Reference> reference_;
    RgbImage halfA_, halfB_, mean_;
    Settings base_;
    double maxSeconds_ = 0.0;  ///< of one picture, so that the reference stays far ahead of it
    std::vector<CandidateRuns> runs_;
    TradeResult result_;
};

/// Turns runs into figures with intervals, and figures into the front, advice and needs.
void summarize(TradeResult& result, const std::vector<CandidateRuns>& runs, const SceneRequirements& scene);

}  // namespace rayscope::measure
