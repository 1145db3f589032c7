#include "base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace rayscope::base {

namespace {

/// Optimal string alignment distance: insertions, deletions, substitutions and swaps of adjacent letters.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, substituted});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], beforeLast[j - 2] + 1);
        }
        beforeLast.swap(last);
        last.swap(current);
    }
    return last[b.size()];
}

/// Names of files may be of any length; the distance takes the product of two lengths.
constexpr std::size_t kLongestName = 64;
/// As many as the longest list of the program itself, that of the built-in scenes.
constexpr std::size_t kMostChoices = 18;

std::string shortened(std::string_view name) {
    if (name.size() <= kLongestName) return std::string(name);
    std::size_t end = kLongestName;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;  // within a character
    return std::string(name.substr(0, end)) + "…";
}

}  // namespace

std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates) {
    std::string_view best;
    if (name.size() > kLongestName) return best;
    std::size_t bestDistance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        // The distance is at least the difference of the lengths.
        if (candidate.size() >= name.size() + bestDistance || name.size() >= candidate.size() + bestDistance)
            continue;
        const std::size_t distance = editDistance(name, candidate);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string didYouMean(std::string_view name, std::span<const std::string_view> candidates) {
    const std::string_view nearest = nearestName(name, candidates);
    return nearest.empty() ? std::string{} : fmt::format(" (did you mean '{}'?)", nearest);
}

std::string joinChoices(std::span<const std::string_view> names) {
    const std::size_t shown = std::min(names.size(), kMostChoices);
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += shortened(names[i]);
    }
    if (shown < names.size()) text += fmt::format(" or {} more", names.size() - shown);
    return text;
}

}  // namespace rayscope::base
