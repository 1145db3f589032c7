#pragma once
// Files below userCacheFolder() and userConfigFolder(): read and written by this user alone.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::base {

/// Creates or replaces the file atomically, with the permissions 0600; missing folders are created with 0700.
/// Throws InputError.
void writePrivateFile(const std::string& path, std::string_view bytes);

/// The whole file, or nothing if there is none. Throws InputError if it cannot be read, is not a regular
/// file, belongs to another user, others may write to it, or it has more than `maxBytes`.
std::optional<std::string> readPrivateFile(const std::string& path, std::size_t maxBytes);

}  // namespace rayscope::base
