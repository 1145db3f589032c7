#pragma once
#include <epoxy/gl.h>
#include <cstddef>

#include "viewer/gl/shader.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// Draws overlay lines as rectangles that face the screen: core profiles promise no line wider than one
/// pixel.
class LineBatch {
  public:
    LineBatch();
    ~LineBatch();
    LineBatch(const LineBatch&) = delete;
    LineBatch& operator=(const LineBatch&) = delete;

    void upload(const OverlayLines& lines);

    /// `viewport` in pixels; `scale` multiplies widths, `opacity` all colours.
    void draw(const glm::mat4& viewProjection, glm::vec2 viewport, float scale, float opacity);

  private:
    Shader shader_{"line"};
    GLuint vertexArray_ = 0, buffer_ = 0;
    GLsizei count_ = 0;
};

}  // namespace rayscope::viewer
