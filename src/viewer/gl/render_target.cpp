#include "viewer/gl/render_target.h"

#include <rayscope/display.h>
#include <array>
#include <stdexcept>

namespace rayscope::viewer {

namespace {

GLuint texture(int width, int height, GLint internalFormat, GLenum format, GLenum type) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return id;
}

GLuint framebuffer(GLuint color, GLuint depth) {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    return id;
}

bool isComplete(GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

void RenderTarget::release() {
    if (framebuffer_ == 0) return;
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteFramebuffers(1, &colorOnly_);
    glDeleteTextures(1, &color_);
    glDeleteTextures(1, &depth_);
    framebuffer_ = 0;
}

bool RenderTarget::resize(int width, int height) {
    if (framebuffer_ != 0 && width == width_ && height == height_) return false;
    release();
    width_ = width;
    height_ = height;
    color_ = texture(width, height, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    depth_ = texture(width, height, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    framebuffer_ = framebuffer(color_, depth_);
    colorOnly_ = framebuffer(color_, 0);
    const bool complete = isComplete(framebuffer_) && isComplete(colorOnly_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) throw std::runtime_error("the OpenGL driver does not support the off-screen framebuffer");
    return true;
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void RenderTarget::bindColorOnly() const {
    glBindFramebuffer(GL_FRAMEBUFFER, colorOnly_);
    glViewport(0, 0, width_, height_);
}

void RenderTarget::readColors(std::vector<std::uint32_t>& pixels) const {
    pixels.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels.data());
}

void RenderTarget::readDepths(std::vector<float>& depths) const {
    depths.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
}

void RenderTarget::writeColors(const std::vector<std::uint32_t>& pixels) const {
    glBindTexture(GL_TEXTURE_2D, color_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV,
                    pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void RenderTarget::copyTo(const RenderTarget& other) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, colorOnly_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.colorOnly_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    other.bind();
}

void RenderTarget::copyToWindow(int x, int y, int width, int height) const {
    const GLenum filter = width == width_ && height == height_ ? GL_NEAREST : GL_LINEAR;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, colorOnly_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT, filter);
    unbind();
}

FramebufferPixels readFramebuffer(int x, int y, int width, int height) {
    FramebufferPixels pixels{width, height, {}};
    pixels.bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.bytes.data());
    return pixels;
}

RgbImage linearImage(const FramebufferPixels& pixels) {
    std::array<float, 256> linear;
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = fromDisplay(Rgb(static_cast<float>(code) / 255.0f)).r;
    RgbImage image(pixels.width, pixels.height);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::uint8_t* pixel = &pixels.bytes[3 * image.index(column, image.height - 1 - row)];
            image.at(column, row) = {linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]};
        }
    return image;
}

}  // namespace rayscope::viewer
