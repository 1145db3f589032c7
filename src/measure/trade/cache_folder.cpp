#include <rayscope/trade.h>

#include <cstdlib>

namespace rayscope {

std::string referenceCacheFolder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value && *value == '/' ? value : "");
    };
    const std::string cache = variable("XDG_CACHE_HOME"), home = variable("HOME");
    if (cache.empty() && home.empty()) return "";
    return (cache.empty() ? home + "/.cache" : cache) + "/rayscope/references";
}

}  // namespace rayscope
