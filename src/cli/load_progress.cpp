#include "cli/load_progress.h"

namespace rayscope::cli {

LoadProgress::LoadProgress(ProgressStyle style)
    : progress_(style),
      control_{.progress = [this](const std::string& step, double fraction) { show(step, fraction); },
               .stop = interrupt_.token()} {}

void LoadProgress::show(const std::string& step, double fraction) {
    constexpr double kQuietSeconds = 1.0, kInterval = 0.1;
    const auto secondsSince = [now = Clock::now()](Clock::time_point then) {
        return std::chrono::duration<double>(now - then).count();
    };
    const double elapsed = secondsSince(start_);
    if (elapsed < kQuietSeconds || secondsSince(shown_) < kInterval) return;
    shown_ = Clock::now();
    progress_.show({fraction, step, {{"step", step}, {"step_progress", fraction}, {"elapsed_s", elapsed}}});
}

}  // namespace rayscope::cli
