#include "viewer/gl/texture.h"

#include <utility>

namespace rayscope::viewer {

namespace {
void setParameters(GLint minify, GLint magnify, GLint wrap) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}
}  // namespace

GlTexture::GlTexture(GlTexture&& other) noexcept { *this = std::move(other); }

GlTexture& GlTexture::operator=(GlTexture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

void GlTexture::release() {
    if (id_ != 0) glDeleteTextures(1, &id_);
    id_ = 0;
}

GlTexture GlTexture::floatImage(int width, int height) {
    GlTexture texture;
    texture.width_ = width;
    texture.height_ = height;
    glGenTextures(1, &texture.id_);
    glBindTexture(GL_TEXTURE_2D, texture.id_);
    // Four channels, because software drivers are slow with three.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGB, GL_FLOAT, nullptr);
    setParameters(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    return texture;
}

GlTexture GlTexture::forMaterial(const Texture& source) {
    GlTexture texture;
    const RgbImage& image = source.image;
    texture.width_ = image.width;
    texture.height_ = image.height;
    glGenTextures(1, &texture.id_);
    glBindTexture(GL_TEXTURE_2D, texture.id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, image.width, image.height, 0, GL_RGB, GL_FLOAT,
                 image.pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    setParameters(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR,
                  source.wrap == TextureWrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    return texture;
}

void GlTexture::upload(const PixelBounds& bounds, const RgbImage& image) {
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, image.width);
    glTexSubImage2D(GL_TEXTURE_2D, 0, bounds.x0, bounds.y0, bounds.x1 - bounds.x0, bounds.y1 - bounds.y0,
                    GL_RGB, GL_FLOAT, &image.at(bounds.x0, bounds.y0));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GlTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, id_);
}

}  // namespace rayscope::viewer
