#include "scene/oddities.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::scene {

void Oddities::add(Severity severity, std::string_view kind, int line, std::size_t count) {
    if (count == 0) return;
    const auto found =
        std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.text == kind; });
    if (found != kinds_.end()) {
        found->count += count;
    } else if (kinds_.size() < kMostKinds) {
        kinds_.push_back({severity, std::string(kind), line, count});
    } else {
        if (others_.count == 0) others_.firstLine = line;
        others_.severity = std::max(others_.severity, severity);
        others_.count += count;
    }
}

void Oddities::report(Diagnostics& notes) const {
    for (const Kind& kind : kinds_) {
        const std::string first = kind.firstLine > 0 ? ", first here" : "";
        const std::string count = kind.count > 1 ? fmt::format(" ({} times{})", kind.count, first) : "";
        notes.push_back({kind.severity, kind.text + count, {path_, kind.firstLine, 0}});
    }
    if (others_.count > 0)
        notes.push_back({others_.severity,
                         fmt::format("{} more messages of other kinds are left out", others_.count),
                         {path_, others_.firstLine, 0}});
}

std::string Oddities::appendix() const {
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, kinds_.size()); ++i) text += "; " + kinds_[i].text;
    return text;
}

}  // namespace rayscope::scene
