#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <stop_token>
#include <vector>

namespace rayscope::shading {

/// A texture with its mip levels: level 0 is the image, each further one halves the size by averaging.
class MipTexture {
  public:
    /// Without `withLevels` there is level 0 only. Throws Stopped.
    MipTexture(std::shared_ptr<const Texture> texture, bool withLevels, const std::stop_token& stop = {});

    /// The linear colour at uv, where (0, 0) is the lower left corner of the image. Non-finite coordinates
    /// read 0. `footprint` is the width of the ray in units of uv; only the mipmap filter uses it.
    glm::dvec3 lookup(const glm::vec2& uv, double footprint, TextureFilter filter) const;

    const Texture* source() const { return texture_.get(); }
    int width() const { return texture_->image.width; }
    int height() const { return texture_->image.height; }

  private:
    const RgbImage& level(std::size_t i) const { return i == 0 ? texture_->image : levels_[i - 1]; }
    glm::dvec3 nearest(const glm::dvec2& uv) const;
    glm::dvec3 bilinear(const RgbImage& image, const glm::dvec2& uv) const;
    glm::dvec3 trilinear(const glm::dvec2& uv, double footprint) const;

    std::shared_ptr<const Texture> texture_;
    std::vector<RgbImage> levels_;
};

/// Texels and weights of a bilinear lookup.
struct BilinearTap {
    int x[2], y[2];
    double weightX, weightY;  ///< of x[1] and y[1]
};
BilinearTap bilinearTap(int width, int height, const glm::dvec2& uv, TextureWrap wrap);

}  // namespace rayscope::shading
