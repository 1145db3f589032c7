#include <rayscope/diagnostics.h>
#include <rayscope/settings.h>

#include <string_view>

#include "fuzz/targets.h"

namespace rayscope::test {

/// A text "key=value" is assigned and reads back to the same value, or is refused with InputError.
bool fuzzSettings(FuzzInput input) {
    const std::string_view text = textOf(input);
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return false;
    const std::string_view key = text.substr(0, sign);
    Settings settings;
    try {
        assign(settings, key, text.substr(sign + 1));
    } catch (const InputError&) {
        return true;
    }
    Settings again;
    assign(again, key, rayscope::textOf(settings, key));
    require(rayscope::textOf(again, key) == rayscope::textOf(settings, key),
            "a setting reads back as it is written");
    return true;
}

}  // namespace rayscope::test
