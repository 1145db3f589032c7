#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace rayscope::cli {

ProgressStyle progressStyle(const std::string& option, bool quiet) {
    if (option == "json") return ProgressStyle::Json;
    if (option == "none" || (quiet && option.empty())) return ProgressStyle::None;
    if (option == "bar") return ProgressStyle::Bar;
    return isatty(STDERR_FILENO) ? ProgressStyle::Bar : ProgressStyle::None;
}

std::string durationText(double seconds) {
    if (seconds < 60.0) return fmt::format("{:.2f} s", seconds);
    const auto whole = static_cast<long>(seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void showProgressBar(double fraction, const std::string& phase, double remainingSeconds) {
    constexpr int kWidth = 32;
    const int full = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} %  {}{}ETA {}", "", full, "", kWidth - full,
               100.0 * fraction, phase, phase.empty() ? "" : "  ",
               remainingSeconds > 0.0 ? durationText(remainingSeconds) : "–");
    std::fflush(stderr);
}

void Progress::show(const RenderStatus& status) {
    if (style_ == ProgressStyle::Json) {
        const nlohmann::json event = {{"progress", status.progress},
                                      {"samples", status.samples},
                                      {"target_samples", status.targetSamples},
                                      {"elapsed_s", status.elapsedSeconds},
                                      {"remaining_s", status.remainingSeconds},
                                      {"rays", status.rays}};
        fmt::print(stderr, "{}\n", event.dump());
    }
    if (style_ != ProgressStyle::Bar) return;
    constexpr int kWidth = 32;
    const int full = static_cast<int>(status.progress * kWidth);
    if (status.state == RenderState::Compiling)
        fmt::print(stderr, "\r\033[K building …");
    else
        fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} %  {} of {} samples  {}  ETA {}", "", full, "",
                   kWidth - full, 100.0 * status.progress, status.samples, status.targetSamples,
                   durationText(status.elapsedSeconds),
                   status.remainingSeconds > 0.0 ? durationText(status.remainingSeconds) : "–");
    std::fflush(stderr);
    drawn_ = true;
}

void Progress::finish(const RenderStatus& status) {
    show(status);
    if (drawn_) fmt::print(stderr, "\n");
}

}  // namespace rayscope::cli
