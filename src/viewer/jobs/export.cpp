#include "viewer/jobs/export.h"

#include <rayscope/display.h>
#include <rayscope/render_image.h>

namespace rayscope::viewer {

void writePicture(const std::string& path, const StillPicture& picture) {
    writeRenderedImage(path, picture.mean(), picture.request().settings, metadataOf(picture));
}

RenderJob::RenderJob(const EditState& state, int width, int height, std::string path, int threads)
    : path_(std::move(path)), session_(threads) {
    checkImageDestination(path_);
    RenderRequest request = requestOf(state, width, height);
    request.progressive = false;
    session_.submit(std::move(request));
}

void RenderJob::update() {
    if (phase_ == Phase::Rendering) {
        const RenderStatus status = session_.status();
        if (status.state == RenderState::Failed) {
            error_ = status.message;
            phase_ = Phase::Failed;
        } else if (status.state == RenderState::Done) {
            phase_ = Phase::Writing;
            writing_.start(
                [path = path_, picture = *session_.picture()](const std::stop_token&, JobProgress&) {
                    writePicture(path, picture.still());
                    return true;
                });
        }
    }
    if (phase_ != Phase::Writing) return;
    if (writing_.poll()) {
        phase_ = Phase::Done;
    } else if (!writing_.busy()) {
        error_ = writing_.error();
        phase_ = Phase::Failed;
    }
}

void RenderJob::cancel() {
    if (phase_ != Phase::Rendering) return;
    session_.cancel();
    phase_ = Phase::Cancelled;
}

}  // namespace rayscope::viewer
