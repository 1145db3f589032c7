#pragma once
#include <epoxy/gl.h>
#include <rayscope/scene.h>
#include <cstdint>
#include <span>
#include <vector>

namespace rayscope::viewer {

/// A mesh in OpenGL buffers, with its triangles sorted by material slot.
class MeshBuffer {
  public:
    explicit MeshBuffer(const MeshData& mesh);
    ~MeshBuffer();
    MeshBuffer(const MeshBuffer&) = delete;
    MeshBuffer& operator=(const MeshBuffer&) = delete;

    /// Triangles of one slot.
    struct Range {
        std::uint32_t slot = 0;
        GLsizei indexCount = 0;
        std::size_t firstIndex = 0;
    };
    std::span<const Range> ranges() const { return ranges_; }
    /// Draws the triangles of a slot, if it has any. Returns their number.
    std::size_t draw(std::uint32_t slot) const;
    std::size_t trianglesOf(std::uint32_t slot) const;

    /// What the positions in the buffer are multiples of; see drawingUnit().
    double unit() const { return unit_; }

    bool hasNormals() const { return hasNormals_; }
    bool hasTexCoords() const { return hasTexCoords_; }
    bool hasColors() const { return hasColors_; }

  private:
    const Range* rangeOf(std::uint32_t slot) const;

    GLuint vertexArray_ = 0;
    static constexpr GLsizei kBuffers = 5;
    GLuint buffers_[kBuffers] = {};  // positions, normals, texture coordinates, colours, indices
    std::vector<Range> ranges_;
    double unit_ = 1.0;
    bool hasNormals_ = false, hasTexCoords_ = false, hasColors_ = false;
};

/// A finely tessellated sphere of radius 1 around the origin.
MeshData unitSphereMesh();

}  // namespace rayscope::viewer
