#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/json_text.h"

namespace rayscope::cli {

namespace {

constexpr const char* kClearLine = "\r\033[K";

std::string barText(double fraction) {
    constexpr int kWidth = 32;
    const int full = static_cast<int>(fraction * kWidth);
    return fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  ", "", full, "", kWidth - full, 100.0 * fraction);
}

std::string jsonText(const ProgressReport& report) {
    nlohmann::json event = nlohmann::json::object();
    for (const auto& [name, value] : report.fields)
        std::visit([&](const auto& v) { event[std::string(name)] = v; }, value);
    return base::jsonText(event, -1);
}

}  // namespace

ProgressStyle progressStyle(const std::string& option, bool quiet) {
    if (option == "json") return ProgressStyle::Json;
    if (option == "none" || (quiet && option.empty())) return ProgressStyle::None;
    if (option == "bar") return ProgressStyle::Bar;
    return isatty(STDERR_FILENO) ? ProgressStyle::Bar : ProgressStyle::None;
}

std::string etaText(double remainingSeconds) {
    return "ETA " + (remainingSeconds > 0.0 ? durationText(remainingSeconds) : "–");
}

void Progress::show(const ProgressReport& report) {
    if (style_ == ProgressStyle::Json) base::writeMessage(jsonText(report));
    if (style_ != ProgressStyle::Bar) return;
    base::writeMessage(kClearLine);
    base::printMessage("{}{}", report.fraction ? barText(*report.fraction) : "", report.text);
    drawn_ = true;
}

void Progress::keep() {
    if (std::exchange(drawn_, false)) base::writeMessage("\n");
}

void Progress::clear() {
    if (std::exchange(drawn_, false)) base::writeMessage(kClearLine);
}

}  // namespace rayscope::cli
