#include "image/codecs/portable_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace rayscope::image {

namespace {

constexpr std::string_view kSpaces = " \t\r\n\v\f";

bool isSpace(char c) { return kSpaces.find(c) != std::string_view::npos; }

template <class Number>
std::optional<Number> parse(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return number;
}

}  // namespace

void PortableHeader::skipSpaces() {
    while (at_ < text_.size()) {
        if (text_[at_] == '#')
            at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
        else if (isSpace(text_[at_]))
            ++at_;
        else
            return;
    }
}

std::string_view PortableHeader::takeWord() {
    skipSpaces();
    const std::size_t first = at_;
    while (at_ < text_.size() && !isSpace(text_[at_]) && text_[at_] != '#') ++at_;
    return text_.substr(first, at_ - first);
}

long long PortableHeader::takeNumber(const char* what) {
    if (const auto number = parse<long long>(takeWord())) return *number;
    file_.damaged(fmt::format("no valid {} in the header", what));
}

float PortableHeader::takeFloat(const char* what) {
    if (const auto number = parse<float>(takeWord())) return *number;
    file_.damaged(fmt::format("no valid {} in the header", what));
}

long long PortableHeader::takeSample() {
    const std::string_view word = takeWord();
    if (word.empty()) file_.damaged(kEndsTooEarly);
    if (const auto number = parse<long long>(word)) return *number;
    file_.damaged("a pixel is not a number");
}

bool PortableHeader::takeBit() {
    skipSpaces();
    if (at_ >= text_.size()) file_.damaged(kEndsTooEarly);
    const char digit = text_[at_++];
    if (digit != '0' && digit != '1') file_.damaged("expected the digits 0 and 1 as pixels");
    return digit == '1';
}

FileBytes PortableHeader::takePixels(std::size_t needed) {
    if (at_ < text_.size() && text_[at_] == '#')
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    // Blanks before the line end, in a file that is just so much longer.
    const std::size_t lineEnd = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    if (lineEnd > at_ && text_.size() - lineEnd == needed + 1 && text_[lineEnd] == '\n') at_ = lineEnd;
    if (text_.substr(at_).starts_with("\r\n") && text_.size() - at_ - 2 >= needed) ++at_;
    if (at_ < text_.size()) ++at_;
    if (text_.size() - at_ < needed) file_.damaged(kEndsTooEarly);
    const FileBytes pixels = file_.bytes.subspan(at_, needed);
    at_ += needed;
    return pixels;
}

void PortableHeader::reportRest() const {
    const std::size_t next = text_.find_first_not_of(kSpaces, at_);
    if (next == std::string_view::npos) return;
    if (text_.size() - next > 2 && text_[next] == 'P' && isSpace(text_[next + 2]))
        file_.warn("a file with several images: only the first is read");
    else
        file_.warn(fmt::format("{} bytes behind the pixels are ignored", text_.size() - at_));
}

}  // namespace rayscope::image
