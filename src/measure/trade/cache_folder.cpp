#include <rayscope/trade.h>

#include "base/user_folders.h"

namespace rayscope {

std::string referenceCacheFolder() {
    const std::filesystem::path folder = base::userCacheFolder();
    return folder.empty() ? std::string() : (folder / "references").string();
}

}  // namespace rayscope
