#pragma once
#include <string>

#include "render/film.h"

namespace rayscope::measure {

/// Keeps two films of the same size in one file, whole or not at all. `hash` stands for what they show.
void saveFilms(const std::string& path, const std::string& hash, const render::Film& a,
               const render::Film& b);

/// Fills two empty films. False, with the films still empty, if there is no such file, it shows something
/// else, or it is damaged.
bool loadFilms(const std::string& path, const std::string& hash, render::Film& a, render::Film& b);

}  // namespace rayscope::measure
