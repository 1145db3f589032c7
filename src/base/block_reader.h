#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/read_file.h"

namespace rayscope::base {

/// Reads a file or pipe from front to back through a buffer of one megabyte.
class BlockReader {
  public:
    static constexpr std::size_t kBlock = std::size_t{1} << 20;

    /// Throws InputError with the path and the reason, and so do the functions that read.
    explicit BlockReader(const std::string& path);

    /// The size of the file in bytes; nothing for pipes and devices.
    std::optional<std::uint64_t> size() const { return size_; }
    /// The number of bytes consumed so far.
    std::uint64_t offset() const { return offset_; }
    /// The number of bytes that are left; the largest number for pipes and devices.
    std::uint64_t remaining() const;

    /// The buffered bytes that follow; fewer than `count` only at the end of the file. `count` is at most
    /// kBlock. Valid until the next call.
    std::string_view peek(std::size_t count) {
        if (end_ - begin_ < count && !atEnd_) refill();
        return {buffer_.data() + begin_, end_ - begin_};
    }
    /// `count` bytes of those that the last peek() returned.
    void consume(std::size_t count) {
        begin_ += count;
        offset_ += count;
    }
    /// Consumes `count` bytes. Returns false if the file ends before.
    bool skip(std::uint64_t count);

  private:
    void refill();

    std::string path_;
    FilePointer file_;
    std::optional<std::uint64_t> size_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;
    std::uint64_t offset_ = 0;
    bool atEnd_ = false;
};

}  // namespace rayscope::base
