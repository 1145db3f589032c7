#include "scene/textures.h"

#include <filesystem>
#include <system_error>

namespace rayscope::scene {

std::shared_ptr<const Texture> TextureCache::open(const std::string& path, TextureWrap wrap) {
    std::shared_ptr<const Texture>& texture = textures_[{path, wrap}];
    std::error_code ignored;
    if (std::filesystem::is_fifo(path, ignored)) throw InputError("is a pipe, not a file", {path});
    if (!texture) texture = std::make_shared<Texture>(Texture{path, readImage(path, &notes_), wrap});
    return texture;
}

}  // namespace rayscope::scene
