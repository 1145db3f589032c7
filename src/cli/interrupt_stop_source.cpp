#include "cli/interrupt_stop_source.h"

#include <chrono>

#include "base/console.h"

namespace rayscope::cli {

InterruptStopSource::InterruptStopSource()
    : watcher_([this](const std::stop_token& ended) { watch(ended); }) {}

void InterruptStopSource::keepResult(std::string notice) {
    notice_ = std::move(notice);
    keepsResult_ = true;
}

void InterruptStopSource::watch(const std::stop_token& ended) {
    constexpr int kEndTicks = 25, kNoticeTicks = 50;  // of 20 ms
    for (int ticks = 0; !ended.stop_requested(); ticks += interrupted() ? 1 : 0) {
        if (interrupted()) stop_.request_stop();
        if (ticks >= kEndTicks && !keepsResult_) endInterrupted();
        if (ticks == kNoticeTicks && !notice_.empty()) base::printMessage("{}\n", notice_);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

}  // namespace rayscope::cli
