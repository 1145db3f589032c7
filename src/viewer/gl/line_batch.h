#pragma once
#include <epoxy/gl.h>
#include <cstddef>

#include "viewer/gl/shader.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// How lines are drawn.
struct LineDrawOptions {
    glm::mat4 viewProjection{1.0f};
    glm::vec2 viewport{1.0f};    ///< in pixels
    float scale = 1.0f;          ///< multiplies widths
    GLuint sceneDepth = 0;       ///< a texture with the depths of the picture; 0: nothing hides lines
    float hiddenOpacity = 1.0f;  ///< of what lies behind surfaces
};

/// Draws overlay lines as rectangles that face the screen: core profiles promise no line wider than one
/// pixel. What is hidden is found in the shader, so that each line is drawn once.
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
