#pragma once
#include <functional>
#include <streambuf>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// Feeds the text of an OBJ file to a reader of streams line by line, and so knows the line that is being
/// read, which the callbacks of tinyobjloader do not tell. Skips a byte order mark, joins lines that end in a
/// backslash, and shows every line that is no vertex, face, comment or blank to `other`.
class ObjLines : public std::streambuf {
  public:
    using Listener = std::function<void(std::string_view line)>;
    ObjLines(std::string& text, Listener other)
        : text_(text), other_(std::move(other)), next_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

    int line() const { return line_; }  ///< counts from 1
    std::string_view current() const { return current_; }

  protected:
    int_type underflow() override;

  private:
    std::string& text_;
    Listener other_;
    std::size_t next_;
    int line_ = 0, nextLine_ = 1;
    std::string_view current_;
};

}  // namespace rayscope::scene
