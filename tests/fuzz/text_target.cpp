#include <nlohmann/json.hpp>

#include <algorithm>

#include "base/json_text.h"
#include "base/printable_text.h"
#include "base/shell_quote.h"
#include "fuzz/targets.h"

namespace rayscope::test {

namespace {

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

/// Any bytes become one line of printable text, a word of a shell, and valid JSON.
bool fuzzPrintableText(FuzzInput input) {
    const std::string text(textOf(input));
    const std::string line = base::printable(text);
    require(std::ranges::none_of(line, isControl), "a printable text has no control character");
    require(base::validUtf8(line) == line, "a printable text is valid UTF-8");
    require(base::printable(line) == line, "a printable text is printed as it is");
    require(base::quoted(text).size() <= 80, "a quoted text is short");
    const std::string word = base::shellQuote(text);
    require(base::printable(word) == word, "a quoted word is printable");
    const std::string path = base::shellQuotePath(text);
    require(!path.starts_with('-'), "a quoted path is no option");
    const std::string json = base::jsonText({{text, text}});
    require(nlohmann::json::accept(json), "JSON is valid for any content");
    require(base::printableLines(json) == json, "JSON is printable");
    return true;
}

}  // namespace rayscope::test
