#include "viewer/jobs/comparison.h"

#include <fmt/format.h>

namespace rayscope::viewer {

namespace {

/// Figures of a picture that still refines are not worth more than one look in this time.
constexpr double kMetricsInterval = 2.0;

}  // namespace

void Comparison::keep(EditState state, RgbImage image, int samples) {
    kept_ = Kept{std::move(state), std::move(image), samples};
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
    if (pending_.valid() && pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const ErrorMeasures metrics = pending_.get();
        measuredAt_ = Clock::now();
        if (kept_ && measuring_.version == view.version) {
            metrics_ = metrics;
            measured_ = measuring_;
        }
    }
    const Pair wanted{view.version, revision, exposure};
    final_ = complete && measured_ == wanted;
    if (!visible() || pending_.valid() || (metrics_ && measured_ == wanted)) return;
    if (b.width != kept_->image.width || b.height != kept_->image.height) {
        metrics_.reset();
        return;
    }
    const double waited = std::chrono::duration<double>(Clock::now() - measuredAt_).count();
    if (!complete && waited < kMetricsInterval) return;
    measuring_ = wanted;
    pending_ = std::async(std::launch::async, [a = kept_->image, b, exposure] {
        CompareOptions options;
        options.exposure = exposure;
        return measureErrors(b, a, options);
    });
}

std::vector<std::string> differencesOf(const EditState& a, const EditState& b) {
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
