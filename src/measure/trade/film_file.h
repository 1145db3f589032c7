#pragma once
#include <string>

#include "render/film.h"

namespace rayscope {

/// Keeps two films of the same size in one file, whole or not at all. `hash` stands for what they show.
void saveFilms(const std::string& path, const std::string& hash, const Film& a, const Film& b);

/// Fills two empty films. False, with the films still empty, if there is no such file, it shows something
/// else, or it is damaged.
bool loadFilms(const std::string& path, const std::string& hash, Film& a, Film& b);

}  // namespace rayscope
