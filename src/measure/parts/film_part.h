#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/film.h"

namespace rayscope::measure {

/// What a part belongs to, and which part it is: the tiles with index ≡ part − 1 (mod parts) of a film.
struct FilmPartHeader {
    std::string contentHash;  ///< filmContentHash()
    std::uint64_t seed = 0;
    int samples = 0;  ///< per pixel, of each tile
    int width = 0, height = 0;
    PixelBounds region;
    int part = 1, parts = 1;

    bool contains(int tile) const { return tile % parts == part - 1; }
};

/// Writes the tiles of a part atomically. Throws InputError if the file cannot be written.
void saveFilmPart(const std::string& path, const FilmPartHeader& header, const render::Film& film);

/// The header of a part. Throws InputError if the file is not a part or one of another version.
FilmPartHeader readFilmPartHeader(const std::string& path);

/// Adds the tiles of one file after another to a film, in the memory of the film and one tile.
class FilmPartMerger {
  public:
    /// `expected`: what all parts must belong to; its part numbers are those of the first file.
    FilmPartMerger(const FilmPartHeader& expected, render::Film& film)
        : expected_(expected), film_(film), added_(static_cast<std::size_t>(expected.parts)) {}

    /// Throws InputError if the file belongs to another image, is damaged or incomplete, or contradicts an
    /// equal part that was added before. Tiles before the damage may have been added.
    void add(const std::string& path);
    /// The numbers of the parts that no file has, from 1.
    std::vector<int> missing() const;

  private:
    FilmPartHeader expected_;
    render::Film& film_;
    std::vector<bool> added_;
};

}  // namespace rayscope::measure
