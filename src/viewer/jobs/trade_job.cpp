#include "viewer/jobs/trade_job.h"

#include <algorithm>

namespace rayscope::viewer {

namespace {

/// Pixels along the longer side: errors do not depend on their number, and times are proportional to it.
constexpr int kLongerSide = 96;

}  // namespace

void TradeJob::start(const EditState& state, glm::ivec2 shown, int threads) {
    const int longer = std::max({shown.x, shown.y, 1});
    TradeRequest request;
    request.render.scene = state.scene;
    request.render.settings = state.settings;
    request.render.camera = camera_ = state.camera;
    request.render.width = std::max(1, kLongerSide * shown.x / longer);
    request.render.height = std::max(1, kLongerSide * shown.y / longer);
    request.budgetSeconds = static_cast<double>(budget);
    request.threads = threads;
    request.cacheFolder = referenceCacheFolder();
    BackgroundJob::start(state.scene, [request](const std::stop_token& stop, std::atomic<double>& fraction) {
        TradeRequest run = request;
        run.stop = stop;
        run.progress = [&fraction](const TradeProgress& progress) { fraction.store(progress.fraction); };
        return measureTrade(run);
    });
}

}  // namespace rayscope::viewer
