#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

#include <rayscope/diagnostics.h>

#include "scene/toml/scene.h"

namespace {

/// Whether the text may request a generated mesh or image that takes seconds to make: a number of four digits
/// or more beside the key `generate`.
bool isExpensive(std::string_view text) {
    if (text.find("generate") == std::string_view::npos) return false;
    int digits = 0;
    for (const char c : text) {
        digits = std::isdigit(static_cast<unsigned char>(c)) || c == '_' ? digits + 1 : 0;
        if (digits >= 4) return true;
    }
    return text.find("subdivisions") != std::string_view::npos;
}

}  // namespace

/// Any text gives a scene or InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (isExpensive(text)) return -1;
    rayscope::Diagnostics notes;
    try {
        const rayscope::SceneDescription scene =
            rayscope::scene::readTomlScene("/nonexistent/fuzzed.toml", text, notes);
        rayscope::lint(scene);
    } catch (const rayscope::InputError&) {
    }
    return 0;
}
