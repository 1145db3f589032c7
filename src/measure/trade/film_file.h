#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "render/film.h"

namespace rayscope::measure {

/// Saves two films of the same size in one file of the user's cache, atomically. `hash` identifies their
/// content. Throws InputError if the file cannot be written or a film holds NaN, infinity, or more than 2^20
/// samples per pixel.
void saveFilms(const std::string& path, const std::string& hash, const render::Film& a,
               const render::Film& b);

/// Fills two empty films. Returns false if the file does not exist. Throws InputError and leaves them empty
/// if readPrivateFile() does, or the file has another hash, size or version, is damaged, or holds what no
/// render can have made: sample counts outside 0 … 2^20, NaN, infinity, or sums that contradict each other.
bool loadFilms(const std::string& path, const std::string& hash, render::Film& a, render::Film& b);

/// The checksum of a file without its last 8 bytes, which hold it.
std::uint64_t filmFileChecksum(std::string_view bytes);

}  // namespace rayscope::measure
