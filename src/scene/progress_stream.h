#pragma once
#include <algorithm>
#include <exception>
#include <streambuf>
#include <string>
#include <string_view>

#include "scene/load_step.h"

namespace rayscope::scene {

/// A text in memory, read in blocks of which each is reported, for parsers that read from a stream.
/// Exceptions of the report, such as Stopped, leave the stream if its exceptions() include badbit. The buffer
/// keeps them, because parsers may turn them into errors of their own.
class ProgressBuffer : public std::streambuf {
  public:
    /// `text` and `control` must outlive the buffer.
    ProgressBuffer(std::string_view text, const LoadControl& control, std::string step)
        : text_(text), step_(control, std::move(step), text.size()) {}

    /// Throws the exception of the report, if there was one.
    void rethrowFailure() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
        const off_type base = from == std::ios::beg   ? 0
                              : from == std::ios::end ? static_cast<off_type>(text_.size())
                                                      : static_cast<off_type>(start_) - (egptr() - gptr());
        const off_type target = base + offset;
        if (target < 0 || target > static_cast<off_type>(text_.size())) return pos_type(off_type(-1));
        start_ = static_cast<std::size_t>(target);
        setg(nullptr, nullptr, nullptr);
        return pos_type(target);
    }
    pos_type seekpos(pos_type position, std::ios::openmode mode) override {
        return seekoff(off_type(position), std::ios::beg, mode);
    }

    int_type underflow() override {
        try {
            step_.advanceTo(start_);
        } catch (...) {
            failure_ = std::current_exception();
            throw;
        }
        if (start_ == text_.size()) return traits_type::eof();
        constexpr std::size_t kBlock = 1 << 16;
        const std::size_t size = std::min(kBlock, text_.size() - start_);
        // The base class wants a pointer that is not const, but writes only in pbackfail().
        char* const block = const_cast<char*>(text_.data()) + start_;
        setg(block, block, block + size);
        start_ += size;
        return traits_type::to_int_type(*block);
    }

    std::string_view text_;
    LoadStep step_;
    std::size_t start_ = 0;  ///< of the next block
    std::exception_ptr failure_;
};

}  // namespace rayscope::scene
