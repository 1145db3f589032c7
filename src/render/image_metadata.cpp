#include "render/image_metadata.h"

#include <fmt/format.h>
#include <rayscope/open_request.h>

#include <filesystem>

namespace rayscope::render {

std::string softwareName() { return "Rayscope " RAYSCOPE_VERSION; }

ImageMetadata imageMetadata(const RenderRequest& request, int samples) {
    ImageMetadata metadata = {{"Software", softwareName()},
                              {"scene", std::filesystem::path(request.scene->path).filename().string()},
                              {"camera", toOptions(request.camera)},
                              {"seed", std::to_string(request.seed)},
                              {"samples", std::to_string(samples)}};
    if (request.scene->edited) metadata["scene.edited"] = "true";
    for (const std::string_view key : settingKeys())
        metadata[fmt::format("setting.{}", key)] = textOf(request.settings, key);
    return metadata;
}

}  // namespace rayscope::render
