#include "viewer/view/traced_view.h"

#include <algorithm>
#include <cmath>

namespace rayscope::viewer {

namespace {

GlTexture uploaded(const RgbImage& image) {
    GlTexture texture = GlTexture::floatImage(image.width, image.height);
    texture.upload({0, image.width, 0, image.height}, image);
    return texture;
}

}  // namespace

TracedView::TracedView() { glGenVertexArrays(1, &emptyVertexArray_); }

TracedView::~TracedView() { glDeleteVertexArrays(1, &emptyVertexArray_); }

std::optional<PixelBounds> TracedView::update(const ShownPicture& shown) {
    const RgbImage& image = shown.image();
    const PixelBounds whole{0, image.width, 0, image.height};
    std::optional<PixelBounds> changed;
    if (shown.replaced()) {
        texture_ = uploaded(image);
        changed = whole;
    }
    for (const PixelBounds& tile : shown.changedTiles()) {
        if (!shown.replaced()) texture_.upload(tile, image);
        if (!changed) changed = tile;
        changed = PixelBounds{std::min(changed->x0, tile.x0), std::max(changed->x1, tile.x1),
                              std::min(changed->y0, tile.y0), std::max(changed->y1, tile.y1)};
    }
    if (shown.bloomChanged()) changed = whole;
    if (!shown.bloomShown())
        bloomTexture_ = GlTexture();
    else if (shown.bloomChanged())
        bloomTexture_ = uploaded(shown.displayed());
    return changed;
}

void TracedView::draw(const Settings& settings, glm::ivec2 size) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (texture_.empty()) {
        glClearColor(0.1f, 0.105f, 0.115f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    fill(shownTexture(), size, std::exp2(settings.exposure), settings.tone == Encoding::None);
}

void TracedView::drawComparison(const Comparison& comparison, const Settings& settings, glm::ivec2 size) {
    const Comparison::View& view = comparison.view;
    const Comparison::Kept& a = *comparison.a();
    if (keptVersion_ != view.version) {
        keptVersion_ = view.version;
        keptTexture_ = uploaded(*a.image);
    }
    if (view.mode == CompareMode::Difference) {
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        fill(shownTexture(), size, view.brightness, false, &keptTexture_);
        return;
    }
    draw(settings, size);
    const int columns = view.mode == CompareMode::Wipe
                            ? static_cast<int>(std::lround(view.divider * static_cast<float>(size.x)))
                            : (view.flipped ? size.x : 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, columns, size.y);
    const Settings& ofA = a.picture.request().settings;
    fill(keptTexture_, size, std::exp2(ofA.exposure), ofA.tone == Encoding::None);
    glDisable(GL_SCISSOR_TEST);
}

void TracedView::drawImage(const RgbImage& image, int version, glm::ivec2 size) {
    if (otherVersion_ != version) {
        otherVersion_ = version;
        otherTexture_ = uploaded(image);
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
