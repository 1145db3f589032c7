#pragma once
// One value of an option: what it may be, in words, and its conversion.
#include <string>
#include <string_view>

namespace rayscope::cli {

struct Option;

/// The form of the value in --help, such as "WxH", "INTEGER" or "a|b"; "" for a flag.
std::string formOf(const Option& option);

/// What the option expects, such as "a number above 0 and below 180". --help and error messages say it in the
/// same words. "" if every text is accepted.
std::string expectationOf(const Option& option);

/// The current value of the variable, as it would be written; "" if it has none.
std::string valueText(const Option& option);

/// Converts the text and sets the variable. Throws UsageError that names the option, what it expects and the
/// text.
void setValue(const Option& option, std::string_view text);

}  // namespace rayscope::cli
