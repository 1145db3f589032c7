#include "post/rendered_outputs.h"

#include <rayscope/diagnostics.h>

#include <utility>

#include "image/encode_image.h"
#include "post/bloom.h"
#include "post/display_transform.h"

namespace rayscope::post {

RenderedOutputs::RenderedOutputs(const RgbImage& mean, const Settings& settings, std::stop_token stop)
    : mean_(mean), settings_(settings), stop_(std::move(stop)) {
    if (!settings.bloom) return;
    try {
        bloomed_ = applyBloom(mean, settings, stop_);
    } catch (const Stopped&) {
        settings_.bloom = false;
        lacksBloom_ = true;
    }
}

template <class Use>
auto RenderedOutputs::withImageFor(const std::string& path, Use use) const {
    const RgbImage& image = settings_.bloom ? bloomed_ : mean_;
    if (!isDisplayFormat(path) || settings_.exposure == 0.0f) return use(image);
    return use(exposed(image, settings_.exposure));
}

void RenderedOutputs::write(const std::string& path, const ImageMetadata& metadata) const {
    withImageFor(path, [&](const RgbImage& image) {
        image::writeImage(path, image, metadata, settings_.tone, stop_);
    });
}

std::string RenderedOutputs::encode(const std::string& suffix, const ImageMetadata& metadata) const {
    return withImageFor("image" + suffix, [&](const RgbImage& image) {
        return image::encodeImage(suffix, image, metadata, settings_.tone, stop_);
    });
}

}  // namespace rayscope::post
