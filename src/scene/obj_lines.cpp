#include "scene/obj_lines.h"

#include <algorithm>

namespace rayscope::scene {

namespace {

/// Vertices, faces, comments and blank lines.
bool isCommon(std::string_view line) {
    switch (line.front()) {
        case 'v': {
            const std::size_t at = line.size() > 1 && (line[1] == 'n' || line[1] == 't') ? 2 : 1;
            return at < line.size() && (line[at] == ' ' || line[at] == '\t');
        }
        case 'f':
            return line.size() > 1 && (line[1] == ' ' || line[1] == '\t');
        case '#':
        case '\r':
        case '\n':
            return true;
        default:
            return false;
    }
}

}  // namespace

ObjLines::int_type ObjLines::underflow() {
    if (next_ >= text_.size()) return traits_type::eof();
    const std::size_t begin = next_;
    line_ = nextLine_;
    const std::size_t first = std::min(text_.find_first_not_of(" \t", begin), text_.size() - 1);
    const bool isComment = text_[first] == '#';
    std::size_t end = begin;
    for (;;) {
        end = text_.find('\n', end);
        if (end == std::string::npos) {
            end = text_.size();
            break;
        }
        ++nextLine_;
        const std::size_t last = end > begin && text_[end - 1] == '\r' ? end - 1 : end;
        if (isComment || last == begin || text_[last - 1] != '\\') {
            ++end;
            break;
        }
        // A continued line: blanks in place of the backslash and the line break.
        for (std::size_t i = last - 1; i <= end; ++i) text_[i] = ' ';
    }
    next_ = end;
    current_ = std::string_view(text_).substr(begin, end - begin);
    if (const std::string_view line = std::string_view(text_).substr(first, end - std::min(first, end));
        !line.empty() && !isCommon(line))
        other_(line);
    else if (const std::size_t hash = current_.find('#'); hash != std::string_view::npos && !isComment)
        // Some programs write remarks behind vertices and faces.
        std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin + hash),
                  text_.begin() + static_cast<std::ptrdiff_t>(begin + current_.find_last_not_of("\r\n") + 1),
                  ' ');
    setg(text_.data() + begin, text_.data() + begin, text_.data() + end);
    return traits_type::to_int_type(text_[begin]);
}

}  // namespace rayscope::scene
