#include "base/data_folders.h"

#include <cstdlib>
#include <string_view>
#include <system_error>

#include "base/user_folders.h"

namespace rayscope::base {

namespace {

namespace fs = std::filesystem;

/// Symbolic links to the program are resolved. Empty where the system does not tell.
fs::path folderOfProgram() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    return failed ? fs::path() : program.parent_path();
}

void addSystemFolders(std::vector<fs::path>& folders) {
    const char* const variable = std::getenv("XDG_DATA_DIRS");
    std::string_view list = variable && *variable ? variable : "/usr/local/share:/usr/share";
    while (!list.empty()) {
        const std::string_view entry = list.substr(0, list.find(':'));
        list.remove_prefix(entry.size() == list.size() ? entry.size() : entry.size() + 1);
        if (entry.starts_with('/')) folders.push_back(fs::path(entry) / "rayscope");
    }
}

}  // namespace

std::vector<fs::path> dataFolders() {
    std::vector<fs::path> folders;
    if (const fs::path program = folderOfProgram(); !program.empty())
        for (const char* const share : {"share", RAYSCOPE_DATA_FROM_PROGRAM})
            folders.push_back((program / share / "rayscope").lexically_normal());
    if (const fs::path user = userDataFolder(); !user.empty()) folders.push_back(user);
    addSystemFolders(folders);
    return folders;
}

fs::path findDataFile(const fs::path& name) {
    std::error_code ignored;
    for (const fs::path& folder : dataFolders())
        if (fs::path path = folder / name; fs::is_regular_file(path, ignored)) return path;
    return {};
}

}  // namespace rayscope::base
