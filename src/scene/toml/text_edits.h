#pragma once
#include <toml++/toml.h>

#include <string>
#include <vector>

namespace rayscope::scene {

/// Changes of a TOML text at the places of parsed nodes; all else stays as it is.
class TextEdits {
  public:
    explicit TextEdits(std::string text);

    void replace(const toml::node& value, std::string replacement);
    /// Adds a line "key = value" below the line.
    void insertBelow(toml::source_index line, const std::string& key, const std::string& value);
    /// Removes whole lines, from the first to the last.
    void removeLines(toml::source_index first, toml::source_index last);
    /// Adds lines at the end of the text.
    void append(const std::string& lines) { appended_ += lines; }
    std::string result() const;

  private:
    struct Edit {
        std::size_t begin, end;
        std::string replacement;
    };
    std::size_t startOf(toml::source_index line) const;
    std::size_t offsetOf(const toml::source_position& position) const;

    std::string text_;
    std::vector<std::size_t> lineStarts_;
    std::vector<Edit> edits_;
    std::string appended_;
};

/// The last line of the node or anything in it.
toml::source_index lastLineOf(const toml::node& node);

}  // namespace rayscope::scene
