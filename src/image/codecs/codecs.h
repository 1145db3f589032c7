#pragma once
// One encoder and one decoder per image format. All work on whole files in memory.
#include <rayscope/diagnostics.h>
#include <rayscope/image.h>
#include <stop_token>
#include <string>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Decoders throw InputError; its messages name the file. They report what they ignore or approximate to the
/// notes, unless these are null.
RgbImage decodeExr(FileBytes file, const std::string& name, Diagnostics* notes = nullptr);
RgbImage decodeBmp(const ImageFile& file);
RgbImage decodeHdr(const ImageFile& file);
RgbImage decodeJpeg(const ImageFile& file);
RgbImage decodePfm(const ImageFile& file);
RgbImage decodePng(const ImageFile& file);
RgbImage decodePnm(const ImageFile& file);
RgbImage decodeTga(const ImageFile& file);

/// Why the file cannot be TGA, which has no signature; "" if it can.
std::string tgaProblem(FileBytes file);

/// Encoders that compress do so as long as no stop of `compressing` is requested; the pixels are the same.
std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata,
                      const std::stop_token& compressing = {});
std::string encodeHdr(const RgbImage& image);
std::string encodePfm(const RgbImage& image);
std::string encodePgm(const RgbImage& image, Encoding encoding);
std::string encodePng(const RgbImage& image, const ImageMetadata& metadata, Encoding encoding,
                      const std::stop_token& compressing = {});
std::string encodePpm(const RgbImage& image, Encoding encoding);

/// The name of a metadata key in a file, distinct from the names that the format itself defines.
inline std::string metadataName(const std::string& key) { return "rayscope:" + key; }

}  // namespace rayscope::image
