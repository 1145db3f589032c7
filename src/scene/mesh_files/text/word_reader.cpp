#include "scene/mesh_files/text/word_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::scene {

namespace {

bool isLineBreak(char c) { return c == '\n' || c == '\r'; }
bool isSpaceOrControl(char c) { return static_cast<unsigned char>(c) <= ' '; }

}  // namespace

std::string_view WordReader::next() {
    while (!skipBlanksInLine())
        if (!skipLineBreak()) {
            wordStart_ = input_.offset();
            return {};
        }
    return takeWord();
}

std::string_view WordReader::nextInLine() {
    if (skipBlanksInLine()) return takeWord();
    wordStart_ = input_.offset();
    return {};
}

void WordReader::skipLine() {
    for (std::string_view text = input_.peek(1); !text.empty(); text = input_.peek(1)) {
        const auto end = std::find_if(text.begin(), text.end(), isLineBreak);
        input_.consume(static_cast<std::size_t>(end - text.begin()));
        if (end != text.end()) break;
    }
    skipLineBreak();
}

SourcePosition WordReader::position() const {
    return {path_, line_, static_cast<int>(wordStart_ - lineStart_) + 1};
}

void WordReader::fail(std::string message) const { throw InputError(std::move(message), position()); }

/// Returns whether a word follows in this line.
bool WordReader::skipBlanksInLine() {
    for (;;) {
        const std::string_view text = input_.peek(kMaxWord);
        std::size_t i = 0;
        while (i < text.size() && isSpaceOrControl(text[i]) && !isLineBreak(text[i])) ++i;
        input_.consume(i);
        if (i < text.size()) return !isLineBreak(text[i]);
        if (text.empty()) return false;
    }
}

/// Returns whether there was one.
bool WordReader::skipLineBreak() {
    const std::string_view text = input_.peek(2);
    if (text.empty()) return false;
    input_.consume(text.starts_with("\r\n") ? 2 : 1);
    ++line_;
    lineStart_ = input_.offset();
    return true;
}

std::string_view WordReader::takeWord() {
    // Blanks were skipped after the last refill, so that less than a word may be left.
    const std::string_view text = input_.peek(kMaxWord);
    const std::size_t limit = std::min(text.size(), kMaxWord);
    std::size_t i = 0;
    while (i < limit && !isSpaceOrControl(text[i])) ++i;
    wordStart_ = input_.offset();
    input_.consume(i);
    return text.substr(0, i);
}

std::string shown(std::string_view word) {
    constexpr std::size_t kMost = 40;
    std::string text(word.substr(0, kMost));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return word.size() > kMost ? text + " ..." : text;
}

}  // namespace rayscope::scene
