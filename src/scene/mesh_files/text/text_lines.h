#pragma once
#include <rayscope/diagnostics.h>

#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// Blanks between words. CR is one of them, so that lines may end with CR LF.
inline bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

/// Without the blanks around it.
std::string_view trimmed(std::string_view text);

/// Splits text into blank-separated words.
class Words {
  public:
    explicit Words(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    /// Empty behind the last word.
    std::string_view next() {
        while (at_ != end_ && isBlank(*at_)) ++at_;
        const char* const begin = at_;
        while (at_ != end_ && !isBlank(*at_)) ++at_;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }
    std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
    /// Drops all further words.
    void stop() { at_ = end_; }

  private:
    const char* at_;
    const char* end_;
};

/// The lines of OBJ and MTL files. A backslash at the end of a line, with or without blanks behind it,
/// continues the line in the next one, unless the line or its end is a comment.
class TextLines {
  public:
    /// `text` as returned by readTextFile(); it must outlive this object.
    TextLines(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    /// Advances to the next line that is neither blank nor a comment; false at the end of the text.
    bool next();

    /// The current line from its first character that is no blank, without its end.
    std::string_view line() const { return line_; }
    /// Of the first of continued lines.
    int number() const { return lineNumber_; }
    /// How many bytes of the text have been read.
    std::size_t offset() const { return next_; }

    /// The position of a character of line().
    SourcePosition positionOf(const char* at) const;

  private:
    struct Part {
        std::size_t begin;  ///< in joined_
        int number;
        std::size_t column;  ///< of its first character, from 0
    };
    std::string_view readLine();
    void joinLines(std::string_view first);

    const std::string& path_;
    std::string_view text_, line_;
    std::size_t next_ = 0, lineBegin_ = 0;
    int lineNumber_ = 0, lastNumber_ = 0;
    std::string joined_;  ///< of continued lines, with blanks for backslashes
    std::vector<Part> parts_;
    bool isJoined_ = false;
};

/// The line before a '#' that follows a blank or starts it.
std::string_view withoutComment(std::string_view line);

}  // namespace rayscope::scene
