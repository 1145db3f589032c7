#pragma once
#include <rayscope/vector.h>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rayscope {

/// A rectangle of pixels, row by row from the top left corner; pixels.size() == width * height.
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

/// Name and value pairs stored in an image file: settings, seed, version.
using ImageMetadata = std::map<std::string, std::string>;

/// How linear values become the bytes of an 8-bit file.
enum class Encoding {
    Srgb,  ///< the piecewise curve of IEC 61966-2-1
    None   ///< clamp and truncate, to compare with images of programs without colour management
};

/// The limit of width times height for images that are read or rendered. Files that announce more are refused
/// before memory is allocated.
inline constexpr long long kMaxImagePixels = 1LL << 28;

/// Reads .png .jpg .bmp .tga .hdr .exr .pfm into linear values; the format is detected from the content.
/// Files with 8 or 16 bits per channel are decoded with the sRGB curve; alpha is ignored. Throws InputError
/// if the file is missing, empty, damaged, in another format or larger than kMaxImagePixels.
RgbImage readImage(const std::string& path);

/// readImage() for a file in memory; `name` is its name in messages.
RgbImage decodeImage(std::span<const std::byte> file, const std::string& name);

/// Writes the format of the suffix: .png (8 bits, with `encoding`), .exr, .pfm, .hdr (linear). Metadata is
/// stored in .png and .exr, under names with the prefix "rayscope:"; the other formats cannot store it. NaN
/// and infinite values are kept in .exr and .pfm; in .png NaN becomes 0 and infinity 255. Replaces an
/// existing file atomically. Throws InputError if the image is empty, the suffix is unknown or the file
/// cannot be written.
void writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata = {},
                Encoding encoding = Encoding::Srgb);

/// The file that writeImage() would write, for a suffix such as ".png". Throws InputError if it is unknown or
/// the image is empty.
std::string encodeImage(const std::string& suffix, const RgbImage& image, const ImageMetadata& metadata = {},
                        Encoding encoding = Encoding::Srgb);

/// Throws InputError unless writeImage() could write `path`: a known suffix and a writable folder.
void checkImageDestination(const std::string& path);

}  // namespace rayscope
