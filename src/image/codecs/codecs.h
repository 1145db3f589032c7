#pragma once
// One encoder and one decoder per image format. All work on whole files in memory.
#include <rayscope/diagnostics.h>
#include <rayscope/image.h>
#include <cstddef>
#include <span>
#include <string>

namespace rayscope::image {

using FileBytes = std::span<const std::byte>;

/// Decoders throw InputError; its messages name the file `name`.
/// Appends notes on what is read approximately to `notes`, if given.
RgbImage decodeExr(FileBytes file, const std::string& name, Diagnostics* notes = nullptr);
RgbImage decodePfm(FileBytes file, const std::string& name);
RgbImage decodeStb(FileBytes file, const std::string& name);  ///< .png .jpg .bmp .tga .hdr

/// Whether the file starts with the signature of the format.
bool looksLikeExr(FileBytes file);
bool looksLikePfm(FileBytes file);

std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata);
std::string encodePfm(const RgbImage& image);
std::string encodeHdr(const RgbImage& image);
std::string encodePng(const RgbImage& image, const ImageMetadata& metadata, Encoding encoding);

/// The name of a metadata key in a file, distinct from the names that the format itself defines.
inline std::string metadataName(const std::string& key) { return "rayscope:" + key; }

/// Throws InputError if an announced size is not positive, exceeds kMaxImagePixels, or cannot be compressed
/// into a file of `fileSize` bytes. To be called before pixels are allocated.
void checkImageSize(long long width, long long height, std::size_t fileSize, const std::string& name);

/// Throws InputError: the file is damaged, because of `reason`.
[[noreturn]] void throwDamaged(const std::string& name, const std::string& reason);

}  // namespace rayscope::image
