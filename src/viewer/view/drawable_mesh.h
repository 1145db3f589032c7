#pragma once
#include <future>
#include <memory>
#include <stop_token>

#include "viewer/gl/mesh_buffer.h"

namespace rayscope::viewer {

/// A mesh in the memory of the graphics card, and a coarse stand-in for it, made beside the window.
class DrawableMesh {
  public:
    explicit DrawableMesh(std::shared_ptr<const MeshData> mesh);
    ~DrawableMesh();
    DrawableMesh(const DrawableMesh&) = delete;
    DrawableMesh& operator=(const DrawableMesh&) = delete;

    std::size_t triangles() const { return mesh_->triangles.size(); }
    const MeshBuffer& whole() const { return whole_; }

    /// From now on a stand-in of about so many triangles is made, if the mesh has more.
    void prepareProxy(std::size_t maxTriangles);
    /// The stand-in as soon as it is ready, before that the mesh.
    const MeshBuffer& proxy();

  private:
    std::shared_ptr<const MeshData> mesh_;
    MeshBuffer whole_;
    std::unique_ptr<MeshBuffer> coarse_;
    std::size_t maxTriangles_ = 0;
    std::stop_source stop_;
    std::future<MeshData> pending_;
};

}  // namespace rayscope::viewer
