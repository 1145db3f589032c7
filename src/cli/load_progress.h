#pragma once
#include <rayscope/scene.h>
#include <chrono>

#include "cli/interrupt_stop_source.h"
#include "cli/progress.h"

namespace rayscope::cli {

/// Shows the steps of a load that takes longer than a second, and ends it with Stopped at the first
/// interrupt.
class LoadProgress {
  public:
    explicit LoadProgress(ProgressStyle style);
    const LoadControl& control() const { return control_; }

  private:
    using Clock = std::chrono::steady_clock;

    void show(const std::string& step, double fraction);

    InterruptStopSource interrupt_;
    Progress progress_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    LoadControl control_;
};

}  // namespace rayscope::cli
