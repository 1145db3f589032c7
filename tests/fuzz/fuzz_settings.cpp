#include <rayscope/diagnostics.h>
#include <rayscope/settings.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

/// A text "key=value" is assigned and reads back to the same value, or is refused with InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return -1;
    const std::string_view key = text.substr(0, sign);
    rayscope::Settings settings;
    try {
        rayscope::assign(settings, key, text.substr(sign + 1));
    } catch (const rayscope::InputError&) {
        return 0;
    }
    rayscope::Settings again;
    rayscope::assign(again, key, rayscope::textOf(settings, key));
    if (rayscope::textOf(again, key) != rayscope::textOf(settings, key)) std::abort();
    return 0;
}
