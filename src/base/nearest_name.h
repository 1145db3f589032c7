#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::base {

/// The candidate that is nearest to `name` by edit distance, if it is near enough to be a slip of the pen;
/// else "".
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// " (did you mean 'x'?)" or "".
std::string didYouMean(std::string_view name, std::span<const std::string_view> candidates);

/// "a, b or c".
std::string joinChoices(std::span<const std::string_view> names);

}  // namespace rayscope::base
