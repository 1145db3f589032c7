#include "viewer/jobs/export.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <rayscope/display.h>
#include <rayscope/render_image.h>
#include <filesystem>

#include "image/srgb.h"
#include "render/image_metadata.h"
#include "viewer/model/camera_text.h"

namespace rayscope::viewer {

std::string nextFreeName(std::string_view suffix) {
    for (int number = 1;; ++number) {
        std::string name = fmt::format("rayscope-{:04}{}", number, suffix);
        std::error_code ignored;
        if (!std::filesystem::exists(name, ignored)) return name;
    }
}

ImageMetadata metadataOf(const EditState& state, std::uint64_t seed, int samples) {
    ImageMetadata metadata = render::imageMetadata(*state.scene, state.settings, seed, samples);
    metadata["camera"] = toOptions(state.camera);
    return metadata;
}

RgbImage readFramebuffer(int x, int y, int width, int height) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    RgbImage image(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const std::uint8_t* pixel = &bytes[3 * image.index(column, height - 1 - row)];
            image.at(column, row) = {image::decodeByte(pixel[0]), image::decodeByte(pixel[1]),
                                     image::decodeByte(pixel[2])};
        }
    return image;
}

RenderJob::RenderJob(const EditState& state, int width, int height, std::string path, int threads)
    : state_(state), path_(std::move(path)), session_(threads) {
    checkImageDestination(path_);
    RenderRequest request;
    request.scene = state.scene;
    request.settings = state.settings;
    request.camera = state.camera;
    request.width = width;
    request.height = height;
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
            writing_ = std::async(std::launch::async, [this, film = session_.film(), status] {
                writeRenderedImage(path_, meanOf(*film), state_.settings,
                                   metadataOf(state_, 0, status.samples));
            });
        }
    }
    if (phase_ == Phase::Writing && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        try {
            writing_.get();
            phase_ = Phase::Done;
        } catch (const std::exception& error) {
            error_ = error.what();
            phase_ = Phase::Failed;
        }
    }
}

void RenderJob::cancel() {
    if (phase_ != Phase::Rendering) return;
    session_.cancel();
    phase_ = Phase::Cancelled;
}

}  // namespace rayscope::viewer
