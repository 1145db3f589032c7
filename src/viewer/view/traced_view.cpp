#include "viewer/view/traced_view.h"

#include <rayscope/display.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace rayscope::viewer {

TracedView::TracedView() { glGenVertexArrays(1, &emptyVertexArray_); }

TracedView::~TracedView() { glDeleteVertexArrays(1, &emptyVertexArray_); }

/// The old picture, scaled, is the placeholder until tiles of the new size arrive.
void TracedView::resize(int width, int height) {
    RgbImage scaled(width, height);
    if (!image_.empty())
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                scaled.at(x, y) = image_.at(x * image_.width / width, y * image_.height / height);
    image_ = std::move(scaled);
    texture_ = GlTexture::floatImage(width, height);
    texture_.upload(0, 0, width, height, image_.pixels.data());
    markChanged({0, width, 0, height});
}

void TracedView::take(const TileView& tile) {
    if (tile.imageWidth != image_.width || tile.imageHeight != image_.height)
        resize(tile.imageWidth, tile.imageHeight);
    for (int y = 0; y < tile.height; ++y) {
        const auto row = tile.mean.begin() + static_cast<std::ptrdiff_t>(y) * tile.width;
        std::copy(row, row + tile.width,
                  image_.pixels.begin() + static_cast<std::ptrdiff_t>(image_.index(tile.x0, tile.y0 + y)));
    }
    texture_.upload(tile.x0, tile.y0, tile.width, tile.height, tile.mean.data());
    markChanged({tile.x0, tile.x0 + tile.width, tile.y0, tile.y0 + tile.height});
}

void TracedView::markChanged(const PixelBounds& bounds) {
    if (!changed_) changed_ = bounds;
    changed_ = PixelBounds{std::min(changed_->x0, bounds.x0), std::max(changed_->x1, bounds.x1),
                           std::min(changed_->y0, bounds.y0), std::max(changed_->y1, bounds.y1)};
}

std::optional<PixelBounds> TracedView::update(RenderSession& session, const Settings& settings,
                                              double budgetSeconds) {
    const PixelBounds before{0, image_.width, 0, image_.height};
    changed_.reset();
    session.collect([this](const TileView& tile) { take(tile); }, budgetSeconds);
    if (changed_) bloomOutdated_ = true;
    if (updateBloom(settings)) markChanged(before);
    if (changed_) ++revision_;
    return changed_;
}

bool TracedView::updateBloom(const Settings& settings) {
    bool arrived = false;
    if (auto image = bloom_.poll()) {
        bloomImage_ = std::move(*image);
        bloomTexture_ = GlTexture::floatImage(bloomImage_.width, bloomImage_.height);
        bloomTexture_.upload(0, 0, bloomImage_.width, bloomImage_.height, bloomImage_.pixels.data());
        bloomShown_ = settings.bloom;
        arrived = true;
    }
    if (!settings.bloom) {
        const bool wasShown = std::exchange(bloomShown_, false);
        bloomOutdated_ = true;
        return arrived || wasShown;
    }
    if (settings != bloomSettings_) bloomOutdated_ = true;
    if (!bloom_.busy() && bloomOutdated_ && !image_.empty()) {
        bloomSettings_ = settings;
        bloomOutdated_ = false;
        bloom_.start([image = image_, settings](const std::stop_token&, JobProgress&) {
            Settings bloomOnly = settings;  // the shader applies the exposure
            bloomOnly.exposure = 0.0f;
            return applyDisplayTransform(image, bloomOnly);
        });
    }
    return arrived;
}

void TracedView::draw(const Settings& settings, glm::ivec2 size) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (texture_.empty()) {
        glClearColor(0.1f, 0.105f, 0.115f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    fill(bloomShown_ ? bloomTexture_ : texture_, size, std::exp2(settings.exposure),
         settings.tone == Encoding::None);
}

void TracedView::drawComparison(const Comparison& comparison, const Settings& settings, glm::ivec2 size) {
    const Comparison::View& view = comparison.view;
    const Comparison::Kept& a = *comparison.a();
    if (keptVersion_ != view.version) {
        keptVersion_ = view.version;
        keptTexture_ = GlTexture::floatImage(a.image->width, a.image->height);
        keptTexture_.upload(0, 0, a.image->width, a.image->height, a.image->pixels.data());
    }
    if (view.mode == CompareMode::Difference) {
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        fill(bloomShown_ ? bloomTexture_ : texture_, size, view.brightness, false, &keptTexture_);
        return;
    }
    draw(settings, size);
    const int columns = view.mode == CompareMode::Wipe
                            ? static_cast<int>(std::lround(view.divider * static_cast<float>(size.x)))
                            : (view.flipped ? size.x : 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, columns, size.y);
    fill(keptTexture_, size, std::exp2(a.state.settings.exposure), a.state.settings.tone == Encoding::None);
    glDisable(GL_SCISSOR_TEST);
}

void TracedView::drawImage(const RgbImage& image, int version, glm::ivec2 size) {
    if (otherVersion_ != version) {
        otherVersion_ = version;
        otherTexture_ = GlTexture::floatImage(image.width, image.height);
        otherTexture_.upload(0, 0, image.width, image.height, image.pixels.data());
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    fill(otherTexture_, size, 1.0f, false);
}

void TracedView::fill(const GlTexture& texture, glm::ivec2 size, float exposureFactor, bool clampOnly,
                      const GlTexture* other) {
    shader_.use();
    shader_.set("image", 0);
    shader_.set("other", 1);
    shader_.set("difference", other != nullptr ? 1 : 0);
    if (other != nullptr) other->bind(1);
    shader_.set("onePixelEach", texture.width() == size.x && texture.height() == size.y ? 1 : 0);
    shader_.set("exposureFactor", exposureFactor);
    shader_.set("clampOnly", clampOnly ? 1 : 0);
    texture.bind(0);
    glBindVertexArray(emptyVertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace rayscope::viewer
