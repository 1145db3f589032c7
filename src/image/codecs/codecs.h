#pragma once
// One pair of functions per kind of image file. All work on whole files in memory.
#include <rayscope/image.h>
#include <cstddef>
#include <span>
#include <string>

namespace rayscope::image {

using FileBytes = std::span<const std::byte>;

/// Decoders throw InputError, in which they call the file `name`.
RgbImage decodeExr(FileBytes file, const std::string& name);
RgbImage decodePfm(FileBytes file, const std::string& name);
RgbImage decodeStb(FileBytes file, const std::string& name);  ///< .png .jpg .bmp .tga .hdr

/// Whether a file begins like one of that kind.
bool looksLikeExr(FileBytes file);
bool looksLikePfm(FileBytes file);

std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata);
std::string encodePfm(const RgbImage& image);
std::string encodeHdr(const RgbImage& image);
std::string encodePng(const RgbImage& image, const ImageMetadata& metadata, Encoding curve);

/// The name under which a metadata key stands in a file, so that it is not taken for one of the format's own.
inline std::string metadataName(const std::string& key) { return "rayscope:" + key; }

/// Throws InputError unless width × height is an image that may be read.
void checkImageSize(long long width, long long height, const std::string& name);

/// Throws InputError: the file is damaged, `why`.
[[noreturn]] void throwDamaged(const std::string& name, const std::string& why);

}  // namespace rayscope::image
