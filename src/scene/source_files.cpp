#include "scene/source_files.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/data_folders.h"
#include "base/read_file.h"
#include "base/user_folders.h"
#include "embedded_scenes.h"
#include "scene/load_step.h"

namespace rayscope::scene {

namespace {

namespace fs = std::filesystem;
constexpr std::string_view kBuiltin = "builtin:";

const scenes::EmbeddedFile* findEmbedded(std::string_view path) {
    if (!path.starts_with(kBuiltin)) return nullptr;
    path.remove_prefix(kBuiltin.size());
    const auto files = scenes::files();
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.name == path; });
    return found == files.end() ? nullptr : &*found;
}

}  // namespace

bool fileExists(const std::string& path) {
    std::error_code ignored;
    return findEmbedded(path) || fs::is_regular_file(path, ignored);
}

void refuseSpecialFile(const std::string& path) {
    std::error_code ignored;
    const fs::file_type type = fs::status(path, ignored).type();
    if (type == fs::file_type::fifo || type == fs::file_type::socket || type == fs::file_type::block ||
        type == fs::file_type::character)
        throw InputError("is a pipe or device, not a regular file", {path});
}

std::string readSource(const std::string& path, const LoadControl& control) {
    if (const auto* embedded = findEmbedded(path)) return std::string(embedded->content);
    std::optional<LoadStep> step;
    return base::readFile(path, [&](std::uintmax_t done, std::uintmax_t total) {
        if (!step) step.emplace(control, "reading " + fs::path(path).filename().string(), total);
        step->advanceTo(done);
    });
}

std::string resolvePath(const std::string& base, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.starts_with(kBuiltin) || fs::path(name).is_absolute()) return name;
    if (!base.starts_with(kBuiltin)) return (fs::path(base).parent_path() / name).lexically_normal().string();
    if (std::string embedded = std::string(kBuiltin) + name; findEmbedded(embedded)) return embedded;
    // Too large to be embedded.
    const fs::path inData = fs::path("scenes") / name;
    const fs::path found = base::findDataFile(inData);
    return (found.empty() ? base::userDataFolder() / inData : found).string();
}

}  // namespace rayscope::scene
