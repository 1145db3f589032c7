#pragma once
#include <rayscope/diagnostics.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace rayscope::image {

using FileBytes = std::span<const std::byte>;

inline std::string_view textOf(FileBytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A file that is decoded: its bytes, its name in messages, and where notes go.
struct ImageFile {
    FileBytes bytes;
    const std::string& name;
    Diagnostics* notes = nullptr;  ///< null: notes are dropped

    /// Reports what the reader chose, e.g. to ignore a colour profile.
    void note(std::string message) const;
    /// Reports what is wrong with a file that can be read nevertheless.
    void warn(std::string message) const;
    /// Throws InputError: the file uses a feature that is not read. `message` says which, and what to do.
    [[noreturn]] void refuse(std::string message) const;
    /// Throws InputError: the file is damaged, because of `reason`.
    [[noreturn]] void damaged(const std::string& reason) const;
};

/// The file does not end before the bytes that its header announces.
inline constexpr const char* kEndsTooEarly = "unexpected end of file";

/// Throws InputError if an announced size is not positive, exceeds kMaxImagePixels, or cannot be compressed
/// into a file of `fileSize` bytes, and OutOfMemory. To be called before pixels are allocated.
void checkImageSize(long long width, long long height, std::size_t fileSize, const std::string& name);

/// Throws InputError: the file is damaged, because of `reason`.
[[noreturn]] void throwDamaged(const std::string& name, const std::string& reason);

}  // namespace rayscope::image
