#include "base/block_reader.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

namespace rayscope::base {

BlockReader::BlockReader(const std::string& path)
    : path_(path), file_(openForReading(path)), buffer_(kBlock) {
    std::error_code unknown;
    const auto size = std::filesystem::file_size(path, unknown);
    if (!unknown) size_ = size;
}

std::uint64_t BlockReader::remaining() const {
    if (!size_) return std::numeric_limits<std::uint64_t>::max();
    return *size_ - std::min(offset_, *size_);
}

bool BlockReader::skip(std::uint64_t count) {
    while (count > 0) {
        const std::string_view bytes = peek(1);
        if (bytes.empty()) return false;
        const std::size_t step = static_cast<std::size_t>(std::min<std::uint64_t>(count, bytes.size()));
        consume(step);
        count -= step;
    }
    return true;
}

/// Moves the rest to the front and fills the buffer.
void BlockReader::refill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    const std::size_t wanted = buffer_.size() - end_;
    const std::size_t read = readBytes(file_.get(), path_, buffer_.data() + end_, wanted);
    end_ += read;
    atEnd_ = read < wanted;
}

}  // namespace rayscope::base
