#pragma once
#include <epoxy/gl.h>
#include <rayscope/image.h>
#include <cstdint>
#include <vector>

namespace rayscope::viewer {

/// An off-screen framebuffer with colour and depth. The view is drawn into it when something changed and
/// copied to the window in every frame, so that an idle window needs hardly any time.
class RenderTarget {
  public:
    RenderTarget() = default;
    ~RenderTarget() { release(); }
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;

    /// Returns whether the size changed; the content is undefined then.
    bool resize(int width, int height);
    /// Makes this the framebuffer that is drawn into, with the viewport over all of it.
    void bind() const;
    /// The same without the depth buffer, so that shaders can read it as depthTexture().
    void bindColorOnly() const;
    GLuint depthTexture() const { return depth_; }
    /// Makes the window the framebuffer that is drawn into.
    static void unbind() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    int width() const { return width_; }
    int height() const { return height_; }
    /// To a rectangle of the window with the lower left corner at (x, y), scaled if the sizes differ.
    void copyToWindow(int x, int y, int width, int height) const;
    /// The colours of all pixels to another target of the same size, which becomes the bound one.
    void copyTo(const RenderTarget& other) const;

    /// Copies the colours (in the format of PaintCanvas) and the depths of all pixels to and from memory.
    void readColors(std::vector<std::uint32_t>& pixels) const;
    void readDepths(std::vector<float>& depths) const;
    void writeColors(const std::vector<std::uint32_t>& pixels) const;

  private:
    void release();

    GLuint framebuffer_ = 0, colorOnly_ = 0, color_ = 0, depth_ = 0;
    int width_ = 0, height_ = 0;
};

/// Encoded colours, 3 bytes per pixel, row by row from the bottom.
struct FramebufferPixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};
/// A rectangle of the bound framebuffer.
FramebufferPixels readFramebuffer(int x, int y, int width, int height);
/// The same as a linear image.
RgbImage linearImage(const FramebufferPixels& pixels);

}  // namespace rayscope::viewer
