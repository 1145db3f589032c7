#pragma once
#include <optional>
#include <string_view>

namespace rayscope::base {

/// The float nearest to the decimal number that the whole word spells, with an optional sign, point and
/// exponent. Values beyond the range of floats become infinite, values below it zero or subnormal. NaN and
/// infinity are read in the spellings of C (nan, -nan(ind), inf, infinity) and of Microsoft's runtime before
/// 2015 (1.#QNAN, -1.#IND, 1.#INF), in either case. Nothing if the word is anything else.
std::optional<float> parseFloat(std::string_view word);

}  // namespace rayscope::base
