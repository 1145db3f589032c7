#include "viewer/jobs/trade_job.h"

#include <algorithm>

namespace rayscope::viewer {

namespace {

/// Pixels along the longer side: few, because times grow with their number and errors hardly depend on it.
constexpr int kLongerSide = 96;

}  // namespace

void TradeJob::start(const EditState& state, glm::ivec2 shown, int threads) {
    const int longer = std::max({shown.x, shown.y, 1});
    TradeRequest request;
    request.render = requestOf(state, std::max(1, kLongerSide * shown.x / longer),
                               std::max(1, kLongerSide * shown.y / longer));
    camera_ = state.camera;
    request.budgetSeconds = static_cast<double>(budget);
    request.threads = threads;
    request.cacheFolder = referenceCacheFolder();
    SceneJob::start(state.scene, [request](const std::stop_token& stop, JobProgress& progress) {
        TradeRequest run = request;
        run.stop = stop;
        run.progress = [&progress](const TradeProgress& now) { progress.store(now.fraction); };
        return measureTrade(run);
    });
}

}  // namespace rayscope::viewer
