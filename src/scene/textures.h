#pragma once
#include <rayscope/scene.h>

#include <map>

namespace rayscope::scene {

/// Loads each image once per scene and wrap mode. What readers of images report goes to the notes.
class TextureCache {
  public:
    explicit TextureCache(Diagnostics& notes) : notes_(notes) {}

    /// Throws InputError if the file cannot be read.
    std::shared_ptr<const Texture> open(const std::string& path, TextureWrap wrap);

  private:
    Diagnostics& notes_;
    std::map<std::pair<std::string, TextureWrap>, std::shared_ptr<const Texture>> textures_;
};

}  // namespace rayscope::scene
