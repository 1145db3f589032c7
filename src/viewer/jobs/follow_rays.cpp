// Recorded rays that follow the settings, the lights and the lens.
#include <algorithm>
#include <utility>

#include "trace/compile.h"
#include "viewer/jobs/debug_rays.h"

namespace rayscope::viewer {

namespace {

/// Whether rays with the same index have the same role.
bool sameRays(const RayTree& a, const RayTree& b) {
    return std::ranges::equal(
               a.nodes, b.nodes,
               [](const RayNode& x, const RayNode& y) { return x.parent == y.parent && x.kind == y.kind; }) &&
           std::ranges::equal(a.shadowRays, b.shadowRays, [](const ShadowRay& x, const ShadowRay& y) {
               return x.node == y.node && x.light == y.light && x.sample == y.sample;
           });
}

}  // namespace

/// The request of the recording with the scene, the settings, the lens and the field of view of the state.
RenderRequest DebugRays::followed(const EditState& state) const {
    RenderRequest request = recording_->request;
    request.scene = state.scene;
    request.settings = state.settings;
    request.camera.lens = state.camera.lens;
    request.camera.fov = state.camera.fov;
    return request;
}

bool DebugRays::isOutdated(const EditState& state) const {
    if (!recording_) return false;
    const RenderRequest request = followed(state);
    return !isSameView(recording_->request, request) || recording_->samples() != request.settings.spp;
}

void DebugRays::follow(const EditState& state, const std::optional<TracedPicture>& picture) {
    if (recording_ && recording_->request.scene->path != state.scene->path) clear();
    if (!recording_ || frozen || following_.busy() || !isOutdated(state)) return;
    // The world of the state is compiled for its picture; that for the other camera shares its geometry.
    RenderRequest ofState = requestOf(state, 1, 1);
    if (!picture) return;
    ofState.camera = picture->request().camera;
    if (!isSameView(picture->request(), ofState)) return;
    following_.start(
        [request = followed(state), shared = picture->world()](const std::stop_token& stop, JobProgress&) {
            auto world = trace::compile({request.scene, request.settings, request.camera, request.width,
                                         request.height, request.keepBinaryTrees},
                                        shared.get(), stop);
            return Followed{request, std::move(world)};
        });
}

/// Records the selected sample again; selected and hidden rays stay so if there are the same rays.
void DebugRays::recordFollowed(Followed followed) {
    const RayTree before = recording_->tree();
    const RaySelection selected = filter.selected;
    const std::vector<RaySelection> hidden = filter.hidden;
    SampleId id = before.name;
    id.index = std::min(id.index, followed.request.settings.spp - 1);
    startRecording(std::move(followed.request), std::move(followed.world), id, nullptr);
    if (!sameRays(before, recording_->tree())) return;
    filter.selected = selected;
    filter.hidden = hidden;
}

}  // namespace rayscope::viewer
