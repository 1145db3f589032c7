#include "scene/mesh_files/obj/mtl_texture.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/parse_float.h"
#include "scene/mesh_files/text/text_lines.h"

namespace rayscope::scene {

namespace {

/// An option with its numbers of values, from `least` to `most`.
struct Option {
    std::string_view name;
    std::size_t least, most;
    bool isNumeric;
    std::string_view neutral;  ///< the value that has no effect; empty: none
};
constexpr std::array kOptions{
    Option{"-s", 1, 3, true, "1"},        Option{"-o", 1, 3, true, "0"},
    Option{"-t", 1, 3, true, "0"},        Option{"-mm", 2, 2, true, ""},
    Option{"-bm", 1, 1, true, "1"},       Option{"-boost", 1, 1, true, "0"},
    Option{"-texres", 1, 1, true, ""},    Option{"-blendu", 1, 1, false, "on"},
    Option{"-blendv", 1, 1, false, "on"}, Option{"-clamp", 1, 1, false, "off"},
    Option{"-cc", 1, 1, false, "off"},    Option{"-imfchan", 1, 1, false, ""},
    Option{"-type", 1, 1, false, ""},     Option{"-colorspace", 1, 1, false, "sRGB"},
};

const Option* optionOf(std::string_view word) {
    const auto found = std::find_if(kOptions.begin(), kOptions.end(),
                                    [&](const Option& option) { return option.name == word; });
    return found == kOptions.end() ? nullptr : &*found;
}

using WordList = std::vector<std::string_view>;

/// The number of values behind the option words[at].
std::size_t countValues(const WordList& words, std::size_t at, const Option& option) {
    std::size_t count = 0;
    while (count < option.most && at + 1 + count < words.size()) {
        const std::string_view value = words[at + 1 + count];
        if (option.isNumeric ? !base::parseFloat(value) : optionOf(value) != nullptr) break;
        ++count;
    }
    return count;
}

bool isNeutral(const Option& option, std::string_view value) {
    if (!option.isNumeric) return value == option.neutral;
    const std::optional<float> number = base::parseFloat(value);
    return !option.neutral.empty() && number == base::parseFloat(option.neutral);
}

void apply(const Option& option, const WordList& words, std::size_t at, std::size_t count,
           TextureArguments& texture) {
    texture.isIncomplete |= count < option.least;
    if (option.name == "-clamp") {
        texture.clamps = count > 0 && words[at + 1] == "on";
        return;
    }
    bool hasEffect = false;
    for (std::size_t i = 0; i < count; ++i) hasEffect |= !isNeutral(option, words[at + 1 + i]);
    if (option.name == "-mm" && count == 2)  // base and gain
        hasEffect = base::parseFloat(words[at + 1]) != 0.0f || base::parseFloat(words[at + 2]) != 1.0f;
    if (option.name == "-s" || option.name == "-o" || option.name == "-t")
        texture.isMoved |= hasEffect;
    else if (hasEffect)
        texture.ignored.emplace(option.name);
}

/// Whether the words from `at` on are options with all their values.
bool areOptions(const WordList& words, std::size_t at) {
    while (at < words.size()) {
        const Option* option = optionOf(words[at]);
        if (!option) return false;
        const std::size_t count = countValues(words, at, *option);
        if (count < option->least) return false;
        at += 1 + count;
    }
    return true;
}

WordList split(std::string_view text) {
    WordList list;
    Words words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) list.push_back(word);
    return list;
}

}  // namespace

TextureArguments parseTexture(std::string_view arguments) {
    TextureArguments texture;
    const WordList words = split(withoutComment(arguments));
    std::size_t at = 0;
    while (at < words.size()) {
        const Option* option = optionOf(words[at]);
        if (!option) break;
        std::size_t count = countValues(words, at, *option);
        // A file may have a number as its name.
        if (at + 1 + count == words.size() && count > option->least) --count;
        apply(*option, words, at, count, texture);
        at += 1 + count;
    }
    if (at == words.size()) return texture;
    std::size_t end = at + 1;
    while (end < words.size() && !(optionOf(words[end]) && areOptions(words, end))) ++end;
    const char* const begin = words[at].data();
    const bool hasOptionsBehind = end < words.size();
    const char* const last = hasOptionsBehind ? words[end - 1].data() + words[end - 1].size()
                                              : arguments.data() + arguments.size();
    texture.file = trimmed({begin, static_cast<std::size_t>(last - begin)});
    while (end < words.size()) {
        const Option& option = *optionOf(words[end]);
        const std::size_t count = countValues(words, end, option);
        apply(option, words, end, count, texture);
        end += 1 + count;
    }
    return texture;
}

}  // namespace rayscope::scene
