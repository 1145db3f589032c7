#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::base {

/// The candidate with the smallest edit distance to `name`, or "" if none is close enough to be a typo or
/// `name` has more than 64 bytes.
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// " (did you mean 'x'?)" or "".
std::string didYouMean(std::string_view name, std::span<const std::string_view> candidates);

/// "a, b or c"; long names and lists are shortened: "a, b, c or 97 more".
std::string joinChoices(std::span<const std::string_view> names);

}  // namespace rayscope::base
