#include <rayscope/diagnostics.h>
#include <rayscope/image.h>

#include <cstring>

#include "fuzz/targets.h"

namespace rayscope::test {

namespace {

/// The image, or one without pixels if the file is refused.
RgbImage decoded(FuzzInput file) {
    try {
        Diagnostics notes;
        return decodeImage(file, "fuzzed", &notes);
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

/// Any bytes are decoded to the same image twice, or refused with InputError.
bool fuzzImage(FuzzInput input) {
    const RgbImage first = decoded(input);
    if (first.pixels.size() > (1u << 20)) return true;
    require(
        first.pixels.size() == static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height),
        "an image has all its pixels");
    const RgbImage second = decoded(input);
    require(first.width == second.width && first.height == second.height &&
                (first.empty() || std::memcmp(first.pixels.data(), second.pixels.data(),
                                              first.pixels.size() * sizeof(Rgb)) == 0),
            "an image depends on its file alone");
    return true;
}

}  // namespace rayscope::test
