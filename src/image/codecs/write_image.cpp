#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "base/atomic_file.h"
#include "base/check_argument.h"
#include "base/lower_case.h"
#include "base/memory_budget.h"
#include "base/nearest_name.h"
#include "image/codecs/codecs.h"
#include "image/encode_image.h"

namespace rayscope {

namespace {

constexpr std::array<std::string_view, 6> kSuffixes{".png", ".exr", ".pfm", ".hdr", ".ppm", ".pgm"};

/// The suffix in lower case. Throws InputError if no encoder has it.
std::string checkedSuffix(const std::string& path) {
    std::string suffix = base::lowerCase(std::filesystem::path(path).extension().string());
    if (std::find(kSuffixes.begin(), kSuffixes.end(), suffix) == kSuffixes.end())
        throw InputError(fmt::format("unknown image format '{}'{}; expected {}", suffix,
                                     base::didYouMean(suffix, kSuffixes), base::joinChoices(kSuffixes)),
                         {path});
    return suffix;
}

std::string encode(const std::string& suffix, const RgbImage& image, const ImageMetadata& metadata,
                   Encoding encoding, const std::stop_token& compressing) {
    // Without compression; while it grows, twice.
    const bool isLinear = suffix == ".exr" || suffix == ".pfm";
    base::requireMemory(image.pixels.size() * (isLinear ? sizeof(Rgb) : 4), "a smaller image (--size)",
                        "the {} file of {} x {} pixels", suffix, image.width, image.height);
    if (suffix == ".png") return image::encodePng(image, metadata, encoding, compressing);
    if (suffix == ".exr") return image::encodeExr(image, metadata, compressing);
    if (suffix == ".pfm") return image::encodePfm(image);
    if (suffix == ".ppm") return image::encodePpm(image, encoding);
    if (suffix == ".pgm") return image::encodePgm(image, encoding);
    return image::encodeHdr(image);
}

}  // namespace

void image::writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata,
                       Encoding encoding, const std::stop_token& compressing) {
    base::checkArgument(hasAllPixels(image), "image: {} x {} pixels with {} stored pixels", image.width,
                        image.height, image.pixels.size());
    checkImageDestination(path);
    if (image.empty()) throw InputError("the image has no pixels", {path});
    base::writeFileAtomically(path, encode(checkedSuffix(path), image, metadata, encoding, compressing));
}

std::string image::encodeImage(const std::string& suffix, const RgbImage& image,
                               const ImageMetadata& metadata, Encoding encoding,
                               const std::stop_token& compressing) {
    base::checkArgument(hasAllPixels(image), "image: {} x {} pixels with {} stored pixels", image.width,
                        image.height, image.pixels.size());
    if (image.empty()) throw InputError("the image has no pixels");
    return encode(checkedSuffix("image" + suffix), image, metadata, encoding, compressing);
}

void writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata,
                Encoding encoding) {
    image::writeImage(path, image, metadata, encoding, {});
}

std::string encodeImage(const std::string& suffix, const RgbImage& image, const ImageMetadata& metadata,
                        Encoding encoding) {
    return image::encodeImage(suffix, image, metadata, encoding, {});
}

void checkImageDestination(const std::string& path) {
    checkedSuffix(path);
    base::checkFileDestination(path);
}

}  // namespace rayscope
