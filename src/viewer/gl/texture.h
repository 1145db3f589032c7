#pragma once
#include <epoxy/gl.h>
#include <rayscope/image.h>
#include <rayscope/render_session.h>
#include <rayscope/scene.h>

namespace rayscope::viewer {

/// A two-dimensional texture of linear RGB values, row 0 at the top of the picture.
class GlTexture {
  public:
    GlTexture() = default;
    ~GlTexture() { release(); }
    GlTexture(GlTexture&& other) noexcept;
    GlTexture& operator=(GlTexture&& other) noexcept;

    /// 32-bit float pixels, interpolated, clamped at the border.
    static GlTexture floatImage(int width, int height);
    /// Half-float pixels with mipmaps; with the wrap mode of `texture`.
    static GlTexture forMaterial(const Texture& texture);

    /// Copies a rectangle of the image to the same place.
    void upload(const PixelBounds& bounds, const RgbImage& image);
    void bind(int unit) const;
    bool empty() const { return id_ == 0; }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    void release();

    GLuint id_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace rayscope::viewer
