#pragma once
#include <epoxy/gl.h>
#include <cstddef>

#include "viewer/gl/shader.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// Parameters of drawing lines.
struct LineDrawOptions {
    glm::mat4 viewProjection{1.0f};
    glm::vec2 viewport{1.0f};    ///< in pixels
    float scale = 1.0f;          ///< multiplies widths
    GLuint sceneDepth = 0;       ///< depth texture of the picture; 0: no line is hidden
    float hiddenOpacity = 1.0f;  ///< of lines behind surfaces
};

/// Draws overlay lines as screen-aligned rectangles, because core profiles only guarantee lines of one pixel.
/// The shader tests the depth, so that hidden and visible parts are drawn in one pass.
class LineBatch {
  public:
    LineBatch();
    ~LineBatch();
    LineBatch(const LineBatch&) = delete;
    LineBatch& operator=(const LineBatch&) = delete;

    void upload(const OverlayLines& lines);
    void draw(const LineDrawOptions& look);

  private:
    Shader shader_{"line"};
    GLuint vertexArray_ = 0, buffer_ = 0;
    GLsizei count_ = 0;
};

}  // namespace rayscope::viewer
