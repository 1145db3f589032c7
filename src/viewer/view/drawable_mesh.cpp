#include "viewer/view/drawable_mesh.h"

#include <utility>

#include "viewer/view/simplify_mesh.h"

namespace rayscope::viewer {

DrawableMesh::DrawableMesh(std::shared_ptr<const MeshData> mesh) : mesh_(std::move(mesh)), whole_(*mesh_) {}

DrawableMesh::~DrawableMesh() { stop_.request_stop(); }

void DrawableMesh::prepareProxy(std::size_t maxTriangles) {
    if (maxTriangles == maxTriangles_) return;
    maxTriangles_ = maxTriangles;
    coarse_.reset();
    stop_.request_stop();
    stop_ = {};
    pending_ = {};
    if (triangles() > maxTriangles)
        pending_ = std::async(std::launch::async, [mesh = mesh_, maxTriangles, stop = stop_.get_token()] {
            return simplifyMesh(*mesh, maxTriangles, stop);
        });
}

const MeshBuffer& DrawableMesh::proxy() {
    if (pending_.valid() && pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        coarse_ = std::make_unique<MeshBuffer>(pending_.get());
    return coarse_ ? *coarse_ : whole_;
}

}  // namespace rayscope::viewer
