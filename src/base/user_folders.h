#pragma once
#include <filesystem>

namespace rayscope::base {

/// Rayscope's folders below $XDG_CACHE_HOME (else ~/.cache) and $XDG_CONFIG_HOME (else ~/.config); they need
/// not exist. Relative paths in these variables and in HOME are ignored, as the XDG Base Directory
/// Specification says. Empty if no variable helps.
std::filesystem::path userCacheFolder();
std::filesystem::path userConfigFolder();

}  // namespace rayscope::base
