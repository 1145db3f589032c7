#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/duration_text.h"

namespace rayscope::cli {

enum class ProgressStyle { Bar, Json, None };

/// The style of --progress; without the option a bar on a terminal and nothing elsewhere.
ProgressStyle progressStyle(const std::string& option, bool quiet);

/// How far a command is, in the two forms that are shown.
struct ProgressReport {
    using Value = std::variant<double, std::uint64_t, std::string>;
    std::optional<double> fraction;                          ///< 0 … 1, drawn as a bar
    std::string text;                                        ///< beside the bar
    std::vector<std::pair<std::string_view, Value>> fields;  ///< of the JSON object
};

/// Shows progress on stderr: one line that is drawn over, or one JSON object per line.
class Progress {
  public:
    explicit Progress(ProgressStyle style) : style_(style) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    void show(const ProgressReport& report);
    /// Ends the line, so that it stays visible.
    void keep();
    /// Erases the line.
    void clear();

  private:
    ProgressStyle style_;
    bool drawn_ = false;
};

using base::durationText;

/// "ETA 2 min 03 s", or "ETA –" if the time is 0, which means unknown.
std::string etaText(double remainingSeconds);

}  // namespace rayscope::cli
