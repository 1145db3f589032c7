#include "measure/grading/image_pairs.h"

#include <rayscope/diagnostics.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <system_error>

#include "base/lower_case.h"

namespace rayscope::measure {

namespace {

namespace fs = std::filesystem;

bool isImageName(const fs::path& path) {
    constexpr std::array<std::string_view, 12> kSuffixes{".png", ".jpg", ".jpeg", ".bmp", ".tga", ".hdr",
                                                         ".exr", ".pfm", ".pnm",  ".ppm", ".pgm", ".pbm"};
    return std::ranges::find(kSuffixes, base::lowerCase(path.extension().string())) != kSuffixes.end();
}

/// Paths relative to the folder, sorted.
std::set<fs::path> imagesIn(const std::string& folder) {
    std::set<fs::path> found;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (isImageName(entry->path()) && entry->is_regular_file(ignored))
            found.insert(entry->path().lexically_relative(folder));
    }
    if (error) throw InputError("cannot be read: " + error.message(), {folder});
    return found;
}

fs::path withoutSuffix(fs::path path) { return path.replace_extension(); }

}  // namespace

ImagePairs pairImages(const std::string& images, const std::string& references) {
    std::set<fs::path> candidates = imagesIn(images);
    const std::set<fs::path> wanted = imagesIn(references);
    if (wanted.empty())
        throw InputError("has no image files; expected .png .exr .pfm .hdr .jpg .ppm …", {references});
    ImagePairs result;
    for (const fs::path& name : wanted) {
        ImagePair pair{name.string(), "", (fs::path(references) / name).string()};
        if (candidates.erase(name) > 0) pair.image = (fs::path(images) / name).string();
        result.pairs.push_back(std::move(pair));
    }
    for (ImagePair& pair : result.pairs) {
        if (!pair.image.empty()) continue;
        const auto isMatch = [stem = withoutSuffix(pair.name)](const fs::path& path) {
            return withoutSuffix(path) == stem;
        };
        if (std::ranges::count_if(candidates, isMatch) != 1) continue;
        const auto match = std::ranges::find_if(candidates, isMatch);
        pair.image = (fs::path(images) / *match).string();
        candidates.erase(match);
    }
    for (const fs::path& path : candidates) result.unpaired.push_back(path.string());
    return result;
}

}  // namespace rayscope::measure
