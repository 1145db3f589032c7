#include "viewer/view/drawable_mesh.h"

#include <utility>

#include "viewer/view/coarse_mesh.h"

namespace rayscope::viewer {

DrawableMesh::DrawableMesh(std::shared_ptr<const MeshData> mesh) : mesh_(std::move(mesh)), whole_(*mesh_) {}

DrawableMesh::~DrawableMesh() { stop_.request_stop(); }

void DrawableMesh::prepareStandIn(std::size_t mostTriangles) {
    if (mostTriangles == mostTriangles_) return;
    mostTriangles_ = mostTriangles;
    coarse_.reset();
    stop_.request_stop();
    stop_ = {};
    coming_ = {};
    if (triangles() > mostTriangles)
        coming_ = std::async(std::launch::async, [mesh = mesh_, mostTriangles, stop = stop_.get_token()] {
            return coarseMesh(*mesh, mostTriangles, stop);
        });
}

const MeshBuffer& DrawableMesh::standIn() {
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        coarse_ = std::make_unique<MeshBuffer>(coming_.get());
    return coarse_ ? *coarse_ : whole_;
}

}  // namespace rayscope::viewer
