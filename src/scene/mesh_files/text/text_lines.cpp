#include "scene/mesh_files/text/text_lines.h"

namespace rayscope::scene {

namespace {

/// The position of the backslash that continues the line; npos: none.
std::size_t continuation(std::string_view line) {
    std::size_t end = line.size();
    while (end > 0 && isBlank(line[end - 1])) --end;
    return end > 0 && line[end - 1] == '\\' ? end - 1 : std::string_view::npos;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view withoutComment(std::string_view line) {
    for (std::size_t hash = line.find('#'); hash != std::string_view::npos; hash = line.find('#', hash + 1))
        if (hash == 0 || isBlank(line[hash - 1])) return line.substr(0, hash);
    return line;
}

std::string_view TextLines::readLine() {
    const char* const begin = text_.data() + next_;
    const std::size_t left = text_.size() - next_;
    const void* const newline = std::memchr(begin, '\n', left);
    const std::size_t length =
        newline ? static_cast<std::size_t>(static_cast<const char*>(newline) - begin) : left;
    next_ += length + (newline ? 1 : 0);
    ++lastNumber_;
    return {begin, length};
}

bool TextLines::next() {
    while (next_ < text_.size()) {
        lineBegin_ = next_;
        line_ = readLine();
        lineNumber_ = lastNumber_;
        isJoined_ = false;
        const auto skipBlanks = [&] {
            while (!line_.empty() && isBlank(line_.front())) line_.remove_prefix(1);
        };
        skipBlanks();
        if (line_.empty() || line_.front() == '#') continue;
        if (continuation(line_) != std::string_view::npos && withoutComment(line_).size() == line_.size()) {
            joinLines(line_);
            skipBlanks();
            if (line_.empty() || line_.front() == '#') continue;
        }
        return true;
    }
    return false;
}

void TextLines::joinLines(std::string_view first) {
    isJoined_ = true;
    joined_.clear();
    parts_.clear();
    std::string_view part = first;
    std::size_t column = static_cast<std::size_t>(first.data() - text_.data()) - lineBegin_;
    for (;;) {
        parts_.push_back({joined_.size(), lastNumber_, column});
        const std::size_t backslash = continuation(part);
        const bool continues =
            backslash != std::string_view::npos && withoutComment(part).size() == part.size();
        joined_.append(continues ? part.substr(0, backslash) : part);
        if (!continues) break;
        joined_.push_back(' ');
        if (next_ >= text_.size()) break;
        part = readLine();
        column = 0;
    }
    line_ = joined_;
}

SourcePosition TextLines::positionOf(const char* at) const {
    if (!isJoined_) {
        const std::size_t column = static_cast<std::size_t>(at - text_.data()) - lineBegin_;
        return {path_, lineNumber_, static_cast<int>(column) + 1};
    }
    const std::size_t offset = static_cast<std::size_t>(at - joined_.data());
    const Part* part = &parts_.front();
    for (const Part& candidate : parts_)
        if (candidate.begin <= offset) part = &candidate;
    return {path_, part->number, static_cast<int>(offset - part->begin + part->column) + 1};
}

}  // namespace rayscope::scene
