#include "viewer/gl/line_batch.h"

namespace rayscope::viewer {

namespace {
/// The per-instance attributes of a line.
struct Instance {
    glm::vec3 from, to;
    glm::vec4 color;
    float width, style;
};
}  // namespace

LineBatch::LineBatch() {
    glGenVertexArrays(1, &vertexArray_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    const auto attribute = [](GLuint index, GLint components, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(index, 1);
    };
    attribute(0, 3, offsetof(Instance, from));
    attribute(1, 3, offsetof(Instance, to));
    attribute(2, 4, offsetof(Instance, color));
    attribute(3, 2, offsetof(Instance, width));
    glBindVertexArray(0);
}

LineBatch::~LineBatch() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &buffer_);
}

void LineBatch::upload(const OverlayLines& lines) {
    std::vector<Instance> instances;
    instances.reserve(lines.size());
    for (const OverlayLine& line : lines)
        instances.push_back({line.from, line.to, line.color, line.width, static_cast<float>(line.style)});
    count_ = static_cast<GLsizei>(instances.size());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                 instances.data(), GL_DYNAMIC_DRAW);
}

void LineBatch::draw(const LineDrawOptions& look) {
    if (count_ == 0) return;
    shader_.use();
    shader_.set("viewProjection", look.viewProjection);
    shader_.set("viewport", look.viewport);
    shader_.set("scale", look.scale);
    shader_.set("sceneDepth", 0);
    shader_.set("depthKnown", look.sceneDepth != 0 ? 1 : 0);
    shader_.set("hiddenOpacity", look.hiddenOpacity);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, look.sceneDepth);
    glBindVertexArray(vertexArray_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace rayscope::viewer
