#include "viewer/jobs/comparison.h"

#include <fmt/format.h>

#include "viewer/jobs/shown_picture.h"

namespace rayscope::viewer {

namespace {

/// Seconds between measurements of a picture that is still being refined.
constexpr double kMetricsInterval = 2.0;

}  // namespace

void Comparison::keep(StillPicture picture) {
    auto image = std::make_shared<const RgbImage>(withBloom(picture.mean(), picture.request().settings));
    kept_ = Kept{std::move(picture), std::move(image)};
    metrics_.reset();
    ++view.version;
}

void Comparison::discard() {
    kept_.reset();
    metrics_.reset();
    view.shown = view.flipped = false;
    ++view.version;
}

void Comparison::update(const RgbImage& b, int revision, bool complete, float exposure) {
    if (const auto measured = job_.poll()) {
        measuredAt_ = Clock::now();
        if (kept_ && measured->pair.version == view.version) {
            metrics_ = measured->metrics;
            measured_ = measured->pair;
        }
    }
    const Pair wanted{view.version, revision, exposure};
    final_ = complete && measured_ == wanted;
    if (!visible() || job_.busy() || (metrics_ && measured_ == wanted)) return;
    if (b.width != kept_->image->width || b.height != kept_->image->height) {
        metrics_.reset();
        return;
    }
    const double age = std::chrono::duration<double>(Clock::now() - measuredAt_).count();
    if (!complete && age < kMetricsInterval) return;
    job_.start([wanted, a = kept_->image, b](const std::stop_token&, JobProgress&) {
        CompareOptions options;
        options.exposure = wanted.exposure;
        return Measured{wanted, measureErrors(b, *a, options)};
    });
}

std::vector<std::string> differencesOf(const RenderRequest& a, const RenderRequest& b) {
    std::vector<std::string> differences;
    for (const std::string_view key : settingKeys()) {
        const std::string before = textOf(a.settings, key), now = textOf(b.settings, key);
        if (before != now) differences.push_back(fmt::format("{} {} -> {}", key, before, now));
    }
    if (a.camera != b.camera) differences.emplace_back("camera");
    if (a.scene != b.scene) differences.emplace_back("scene");
    return differences;
}

}  // namespace rayscope::viewer
