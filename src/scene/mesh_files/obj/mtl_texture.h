#pragma once
#include <set>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// The arguments of a texture statement of an MTL file, e.g. "-s 2 2 1 wood.png".
struct TextureArguments {
    std::string_view file;            ///< as written, with quotes and comments; empty: none
    bool clamps = false;              ///< -clamp on
    bool isMoved = false;             ///< -s, -o or -t with other than their default values
    std::set<std::string> ignored{};  ///< other options that would change the texture
    bool isIncomplete = false;        ///< an option lacks values
};

/// Options may stand before or behind the name of the file, which may have blanks in it.
TextureArguments parseTexture(std::string_view arguments);

}  // namespace rayscope::scene
