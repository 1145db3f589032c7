#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace rayscope::base {

/// Throws std::invalid_argument with the message, which starts with the name of the argument, unless
/// `isValid`.
template <class... Values>
void checkArgument(bool isValid, fmt::format_string<Values...> message, Values&&... values) {
    if (!isValid) throw std::invalid_argument(fmt::format(message, std::forward<Values>(values)...));
}

}  // namespace rayscope::base
