#pragma once
#include <string>
#include <string_view>

namespace rayscope::scene {

/// What a file is that is not of the format `own`, e.g. "PLY", and what to do, e.g. "is compressed with …".
/// `start`: its first bytes. Empty if they are not known.
std::string_view foreignFormat(std::string_view start, std::string_view own);

/// The message about such a file. `because`: what is wrong if foreignFormat() does not know it, e.g. "does
/// not begin with …".
std::string describeForeign(std::string_view start, std::string_view own, std::string_view because);

}  // namespace rayscope::scene
