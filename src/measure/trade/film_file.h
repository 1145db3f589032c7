#pragma once
#include <string>

#include "render/film.h"

namespace rayscope::measure {

/// Saves two films of the same size in one file, atomically. `hash` identifies their content. Throws
/// InputError if the file cannot be written.
void saveFilms(const std::string& path, const std::string& hash, const render::Film& a,
               const render::Film& b);

/// Fills two empty films. Returns false and leaves them empty if the file does not exist, has another hash or
/// size, or is damaged.
bool loadFilms(const std::string& path, const std::string& hash, render::Film& a, render::Film& b);

}  // namespace rayscope::measure
