#pragma once
#include <rayscope/scene.h>

#include <map>

namespace rayscope::scene {

/// Loads each image once per scene and wrap mode.
class TextureCache {
  public:
    /// `control` must outlive the cache.
    explicit TextureCache(const LoadControl& control) : control_(control) {}
    /// Throws InputError if the file cannot be read, and Stopped.
    std::shared_ptr<const Texture> open(const std::string& path, TextureWrap wrap);

  private:
    const LoadControl& control_;
    std::map<std::pair<std::string, TextureWrap>, std::shared_ptr<const Texture>> textures_;
};

}  // namespace rayscope::scene
