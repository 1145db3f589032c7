#include "viewer/jobs/comparison.h"

#include <fmt/format.h>

namespace rayscope::viewer {

namespace {

/// Figures of a picture that still refines are not worth more than one look in this time.
constexpr double kPatience = 2.0;

}  // namespace

void Comparison::keep(EditState state, RgbImage image, int samples) {
    kept_ = Kept{std::move(state), std::move(image), samples};
    figures_.reset();
    ++view.version;
}

void Comparison::forget() {
    kept_.reset();
    figures_.reset();
    view.shown = view.flipped = false;
    ++view.version;
}

void Comparison::update(const RgbImage& b, int revision, bool complete, float exposure) {
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const ErrorMeasures figures = coming_.get();
        measuredAt_ = Clock::now();
        if (kept_ && measuring_.version == view.version) {
            figures_ = figures;
            measured_ = measuring_;
        }
    }
    const Pair wanted{view.version, revision, exposure};
    final_ = complete && measured_ == wanted;
    if (!visible() || coming_.valid() || (figures_ && measured_ == wanted)) return;
    if (b.width != kept_->image.width || b.height != kept_->image.height) {
        figures_.reset();
        return;
    }
    const double waited = std::chrono::duration<double>(Clock::now() - measuredAt_).count();
    if (!complete && waited < kPatience) return;
    measuring_ = wanted;
    coming_ = std::async(std::launch::async, [a = kept_->image, b, exposure] {
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
