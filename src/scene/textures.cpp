#include "scene/textures.h"

#include <filesystem>
#include <span>

#include "scene/load_step.h"
#include "scene/source_files.h"

namespace rayscope::scene {

std::shared_ptr<const Texture> TextureCache::open(const std::string& path, TextureWrap wrap) {
    std::shared_ptr<const Texture>& texture = textures_[{path, wrap}];
    refuseSpecialFile(path);
    if (!texture) {
        const std::string file = readSource(path, control_);
        const LoadStep step(control_, "decoding " + std::filesystem::path(path).filename().string(), 0);
        texture = std::make_shared<Texture>(
            Texture{path, decodeImage(std::as_bytes(std::span(file)), path, &notes_), wrap});
    }
    return texture;
}

}  // namespace rayscope::scene
