#pragma once
#include <epoxy/gl.h>
#include <cstdint>
#include <vector>

namespace rayscope::viewer {

/// An off-screen picture with a depth buffer. The view is drawn into it when something changed, and copied to
/// the window in every frame, so that an idle window costs next to nothing.
class RenderTarget {
  public:
    RenderTarget() = default;
    ~RenderTarget() { release(); }
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;

    /// Gives it this size; the content is undefined if the size changed. Returns whether it did.
    bool resize(int width, int height);
    /// All drawing goes here, over the whole target.
    void bind() const;
    /// The same without the depth buffer, which can be read as depthTexture() meanwhile.
    void bindColorOnly() const;
    GLuint depthTexture() const { return depth_; }
    /// Drawing goes to the window again.
    static void unbind() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    int width() const { return width_; }
    int height() const { return height_; }
    /// To a rectangle of the window with the lower left corner at (x, y): pixel by pixel, or enlarged.
    void copyToWindow(int x, int y, int width, int height) const;
    /// The colours of all pixels, to another target of the same size, which becomes the bound one.
    void copyTo(const RenderTarget& other) const;

    /// The colours of all pixels, as PaintCanvas has them, and their depths; to and from memory.
    void readColors(std::vector<std::uint32_t>& pixels) const;
    void readDepths(std::vector<float>& depths) const;
    void writeColors(const std::vector<std::uint32_t>& pixels) const;

  private:
    void release();

    GLuint framebuffer_ = 0, colorOnly_ = 0, color_ = 0, depth_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace rayscope::viewer
