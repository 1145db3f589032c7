#pragma once
#include <rayscope/scene.h>

#include <map>

namespace rayscope::scene {

/// Loads each image once per scene and wrap mode. What readers of images report goes to the notes.
class TextureCache {
  public:
    /// Both must outlive the cache.
    TextureCache(Diagnostics& notes, const LoadControl& control) : notes_(notes), control_(control) {}
    /// Throws InputError if the file cannot be read, and Stopped.
    std::shared_ptr<const Texture> open(const std::string& path, TextureWrap wrap);

  private:
    Diagnostics& notes_;
    const LoadControl& control_;
    std::map<std::pair<std::string, TextureWrap>, std::shared_ptr<const Texture>> textures_;
};

}  // namespace rayscope::scene
