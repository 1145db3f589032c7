#include "base/user_folders.h"

#include <cstdlib>

namespace rayscope::base {

namespace {

namespace fs = std::filesystem;

fs::path absoluteVariable(const char* name) {
    const char* const value = std::getenv(name);
    return value && *value == '/' ? fs::path(value) : fs::path();
}

fs::path folderBelow(const char* variable, const char* nameInHome) {
    if (const fs::path folder = absoluteVariable(variable); !folder.empty()) return folder / "rayscope";
    const fs::path home = absoluteVariable("HOME");
    return home.empty() ? home : home / nameInHome / "rayscope";
}

}  // namespace

fs::path userCacheFolder() { return folderBelow("XDG_CACHE_HOME", ".cache"); }
fs::path userConfigFolder() { return folderBelow("XDG_CONFIG_HOME", ".config"); }
fs::path userDataFolder() { return folderBelow("XDG_DATA_HOME", ".local/share"); }

}  // namespace rayscope::base
