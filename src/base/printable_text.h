#pragma once
// Text of files and arguments, made safe for terminals and for lines of messages.
#include <cstddef>
#include <string>
#include <string_view>

namespace rayscope::base {

/// The text with every control character, invisible direction mark and byte that is not UTF-8 as an escape:
/// \n, \t, \xNN or \u{NNNN}. The result is one line of valid UTF-8.
std::string printable(std::string_view text);

/// printable(), but line feeds stay: for texts of several lines.
std::string printableLines(std::string_view text);

/// The text, with " … " in place of its middle if it has more than `most` bytes. `most` is at least 8.
std::string shortened(std::string text, std::size_t most);

/// The text in single quotes, printable and shortened to about `most` bytes.
std::string quoted(std::string_view text, std::size_t most = 60);

/// The text with U+FFFD in place of every byte that is not UTF-8 and of every control character but line feed
/// and tab: for HTML, SVG and the window.
std::string validUtf8(std::string_view text);

/// JSON text whose strings hold no control character as it is: DEL, U+0080 to U+009F and direction marks,
/// which JSON allows, become \uNNNN. The text is valid UTF-8.
std::string printableJson(std::string_view json);

}  // namespace rayscope::base
