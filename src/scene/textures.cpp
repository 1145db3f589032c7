#include "scene/textures.h"

namespace rayscope::scene {

std::shared_ptr<const Texture> TextureCache::open(const std::string& path, TextureWrap wrap) {
    std::shared_ptr<const Texture>& texture = textures_[{path, wrap}];
    if (!texture) texture = std::make_shared<Texture>(Texture{path, readImage(path, &notes_), wrap});
    return texture;
}

}  // namespace rayscope::scene
