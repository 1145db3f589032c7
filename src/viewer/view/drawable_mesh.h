#pragma once
#include <memory>

#include "viewer/gl/mesh_buffer.h"
#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// A mesh in OpenGL buffers, and a simplified proxy of it that is computed in the background.
class DrawableMesh {
  public:
    explicit DrawableMesh(std::shared_ptr<const MeshData> mesh);

    std::size_t triangles() const { return mesh_->triangles.size(); }
    const MeshBuffer& whole() const { return whole_; }

    /// Computes a proxy of about `maxTriangles` triangles, if the mesh has more.
    void prepareProxy(std::size_t maxTriangles);
    /// The proxy, or the mesh itself until there is one.
    const MeshBuffer& proxy();

  private:
    std::shared_ptr<const MeshData> mesh_;
    MeshBuffer whole_;
    std::unique_ptr<MeshBuffer> proxy_;
    std::size_t maxTriangles_ = 0;
    BackgroundJob<MeshData> simplification_;
};

}  // namespace rayscope::viewer
