#pragma once
#include <filesystem>

namespace rayscope::base {

/// Rayscope's folders below $XDG_CACHE_HOME (else ~/.cache), $XDG_CONFIG_HOME (else ~/.config) and
/// $XDG_DATA_HOME (else ~/.local/share); they need not exist. Relative paths in these variables and in HOME
/// are ignored, as the XDG Base Directory Specification says. Empty if no variable helps.
std::filesystem::path userCacheFolder();
std::filesystem::path userConfigFolder();
std::filesystem::path userDataFolder();

}  // namespace rayscope::base
