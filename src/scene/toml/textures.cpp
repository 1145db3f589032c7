#include "scene/toml/textures.h"

#include <algorithm>

#include "scene/toml/record.h"

namespace rayscope::scene {

namespace {

constexpr std::array<std::string_view, 2> kGenerators{"checker", "texels"};

struct GeneratedTexture {
    int columns = 8, rows = 8;
    std::vector<Rgb> colors;
};

std::pair<int, int> readPair(const TomlValue& value) {
    const toml::array& array = readArray(value, 2, "integers");
    return {readInteger({value.file, array[0], value.key}, 1, 4096),
            readInteger({value.file, array[1], value.key}, 1, 4096)};
}

std::vector<Rgb> readColors(const TomlValue& value, std::size_t count) {
    const toml::array& array = readArray(value, count, "colours");
    std::vector<Rgb> colors;
    for (const toml::node& color : array)
        colors.push_back(readColor({value.file, color, value.key}, kFraction));
    return colors;
}

/// Each field is `kTexels` wide, so that its edges stay sharp with bilinear filtering.
RgbImage checker(const GeneratedTexture& texture) {
    constexpr int kTexels = 16;
    RgbImage image(std::min(texture.columns * kTexels, 4096), std::min(texture.rows * kTexels, 4096));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int field = x * texture.columns / image.width + y * texture.rows / image.height;
            image.at(x, y) = texture.colors[static_cast<std::size_t>(field % 2)];
        }
    return image;
}

RgbImage texels(const GeneratedTexture& texture) {
    RgbImage image(texture.columns, texture.rows);
    image.pixels = texture.colors;
    return image;
}

}  // namespace

std::span<const std::string_view> generatedTextureKeys() {
    static constexpr std::array<std::string_view, 4> kKeys{"generate", "cells", "size", "colors"};
    return kKeys;
}

RgbImage readGeneratedTexture(const TomlValue& value) {
    const toml::table& body = readTable(value);
    const bool isChecker = readChoice({value.file, *body.get("generate"), "generate"}, kGenerators) == 0;
    const std::string_view sizeKey = isChecker ? "cells" : "size";
    if (const toml::node* other = body.get(isChecker ? "size" : "cells"))
        TomlValue{value.file, *other, isChecker ? "size" : "cells"}.fail(
            fmt::format("a {} has the key '{}' instead", isChecker ? "checker" : "texel image", sizeKey));
    GeneratedTexture texture{.colors = {Rgb(0.8f), Rgb(0.2f)}};
    if (const toml::node* size = body.get(sizeKey))
        std::tie(texture.columns, texture.rows) = readPair({value.file, *size, sizeKey});
    else if (!isChecker)
        value.fail("texels need size = [columns, rows]");
    const auto count = static_cast<std::size_t>(texture.columns) * static_cast<std::size_t>(texture.rows);
    if (const toml::node* colors = body.get("colors"))
        texture.colors = readColors({value.file, *colors, "colors"}, isChecker ? 2 : count);
    else if (!isChecker)
        value.fail("texels need colors = [one per texel, row by row from the top left]");
    return isChecker ? checker(texture) : texels(texture);
}

}  // namespace rayscope::scene
