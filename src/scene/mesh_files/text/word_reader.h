#pragma once
#include <rayscope/diagnostics.h>

#include <string>
#include <string_view>

#include "base/block_reader.h"

namespace rayscope::scene {

/// Splits a text file into words, with positions. Blanks are all characters up to the space; lines end with
/// LF, CR LF or CR.
class WordReader {
  public:
    /// Words longer than this are cut into several.
    static constexpr std::size_t kMaxWord = 4096;

    /// Starts at the next byte of `input`, which is in line `line` of the file `path`. All of them must
    /// outlive the reader.
    WordReader(const std::string& path, base::BlockReader& input, int line)
        : path_(path), input_(input), line_(line), lineStart_(input.offset()) {}

    /// The next word, in this line or a later one; empty at the end of the file. Valid until the next call.
    std::string_view next();
    /// The next word of the current line; empty at its end.
    std::string_view nextInLine();
    void skipLine();

    /// The position of the last word; of the end of the line or file, if there was none.
    SourcePosition position() const;
    int line() const { return line_; }
    std::uint64_t offset() const { return input_.offset(); }
    /// An error at position().
    [[noreturn]] void fail(std::string message) const;

  private:
    bool skipBlanksInLine();
    bool skipLineBreak();
    std::string_view takeWord();

    const std::string& path_;
    base::BlockReader& input_;
    int line_;
    std::uint64_t lineStart_;      ///< offset of the first byte of the line
    std::uint64_t wordStart_ = 0;  ///< offset of the last word
};

/// A word for an error message: printable ASCII characters, at most 40.
std::string shown(std::string_view word);

}  // namespace rayscope::scene
