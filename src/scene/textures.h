#pragma once
#include <rayscope/scene.h>

#include <map>

namespace rayscope::scene {

/// Loads each image once per scene and wrap mode.
class TextureCache {
  public:
    /// Throws InputError if the file cannot be read.
    std::shared_ptr<const Texture> open(const std::string& path, TextureWrap wrap);

  private:
    std::map<std::pair<std::string, TextureWrap>, std::shared_ptr<const Texture>> textures_;
};

}  // namespace rayscope::scene
