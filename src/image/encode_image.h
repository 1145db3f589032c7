#pragma once
// Writing images when somebody waits for the end of the program.
#include <rayscope/image.h>
#include <stop_token>
#include <string>

namespace rayscope::image {

/// encodeImage() and writeImage(). After a stop of `compressing` PNG and EXR files are not compressed:
/// larger, sooner complete, and with the same pixels. The other formats take about the time of copying the
/// image.
std::string encodeImage(const std::string& suffix, const RgbImage& image, const ImageMetadata& metadata,
                        Encoding encoding, const std::stop_token& compressing);
void writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata,
                Encoding encoding, const std::stop_token& compressing);

}  // namespace rayscope::image
