#include <rayscope/image.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include <rayscope/diagnostics.h>

namespace {

/// The image, or one without pixels if the file is refused.
rayscope::RgbImage decode(std::span<const std::byte> file) {
    try {
        return rayscope::decodeImage(file, "fuzzed");
    } catch (const rayscope::InputError&) {
        return {};
    }
}

}  // namespace

/// Any bytes are decoded to the same image twice, or refused with InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span file(reinterpret_cast<const std::byte*>(data), size);
    const rayscope::RgbImage first = decode(file);
    if (first.pixels.size() > (1u << 20)) return 0;
    const rayscope::RgbImage second = decode(file);
    const bool isSame = first.width == second.width && first.height == second.height &&
                        (first.empty() || std::memcmp(first.pixels.data(), second.pixels.data(),
                                                      first.pixels.size() * sizeof(rayscope::Rgb)) == 0);
    if (!isSame) std::abort();
    return 0;
}
