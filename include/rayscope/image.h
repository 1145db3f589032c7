#pragma once
#include <rayscope/vector.h>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rayscope {

/// A rectangle of pixels, row by row from the top left corner.
template <class Pixel>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    Image(int w, int h, Pixel fill = Pixel{})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    bool empty() const { return pixels.empty(); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    Pixel& at(int x, int y) { return pixels[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

using RgbImage = Image<Rgb>;

/// Name and value pairs that travel inside the file: settings, seed, version.
using ImageMetadata = std::map<std::string, std::string>;

/// How linear values become the bytes of an 8-bit file.
enum class Encoding {
    Srgb,  ///< the piecewise curve of IEC 61966-2-1
    None   ///< none: clamp and truncate, to compare with pictures of programs that do no colour management
};

/// Larger images are refused before anything is allocated for them.
inline constexpr long long kMaxImagePixels = 1LL << 26;

/// Reads .png .jpg .bmp .tga .hdr .exr .pfm into linear values; the kind is told from the content. Files of 8
/// or 16 bits are decoded with the sRGB curve; alpha is left out. Throws InputError if the file is missing,
/// empty, damaged or holds more than kMaxImagePixels.
RgbImage readImage(const std::string& path);

/// The same for a file that already is in memory; messages call it `name`.
RgbImage decodeImage(std::span<const std::byte> file, const std::string& name);

/// Writes by suffix: .png (8 bit, with `curve`), .exr, .pfm, .hdr (linear). Metadata goes into .png and .exr,
/// under names that begin with "rayscope:"; the other formats have no place for it. NaN and infinite values
/// stay as they are in .exr and .pfm; in .png NaN becomes 0 and infinity 255. The file appears whole or not
/// at all. Throws InputError if it cannot be written or the suffix is unknown.
void writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata = {},
                Encoding curve = Encoding::Srgb);

/// Throws InputError unless writeImage(path, …) could write there: the suffix is known and the folder is
/// writable.
void checkImageDestination(const std::string& path);

}  // namespace rayscope
