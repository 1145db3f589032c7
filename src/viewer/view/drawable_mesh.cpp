#include "viewer/view/drawable_mesh.h"

#include <utility>

#include "viewer/view/simplify_mesh.h"

namespace rayscope::viewer {

DrawableMesh::DrawableMesh(std::shared_ptr<const MeshData> mesh) : mesh_(std::move(mesh)), whole_(*mesh_) {}

void DrawableMesh::prepareProxy(std::size_t maxTriangles) {
    if (maxTriangles == maxTriangles_) return;
    maxTriangles_ = maxTriangles;
    proxy_.reset();
    simplification_.discard();
    if (triangles() > maxTriangles)
        simplification_.start([mesh = mesh_, maxTriangles](const std::stop_token& stop, JobProgress&) {
            return simplifyMesh(*mesh, maxTriangles, stop);
        });
}

const MeshBuffer& DrawableMesh::proxy() {
    if (const auto mesh = simplification_.poll()) proxy_ = std::make_unique<MeshBuffer>(*mesh);
    return proxy_ ? *proxy_ : whole_;
}

}  // namespace rayscope::viewer
