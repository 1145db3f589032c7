#include "render/image_metadata.h"

#include <fmt/format.h>

#include <filesystem>

namespace rayscope::render {

std::string softwareName() { return "Rayscope " RAYSCOPE_VERSION; }

ImageMetadata imageMetadata(const SceneDescription& scene, const Settings& settings, std::uint64_t seed,
                            int samples) {
    ImageMetadata metadata = {{"Software", softwareName()},
                              {"scene", std::filesystem::path(scene.path).filename().string()},
                              {"seed", std::to_string(seed)},
                              {"samples", std::to_string(samples)}};
    for (const std::string_view key : settingKeys())
        metadata[fmt::format("setting.{}", key)] = textOf(settings, key);
    return metadata;
}

}  // namespace rayscope::render
