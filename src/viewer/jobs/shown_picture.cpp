#include "viewer/jobs/shown_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "post/bloom.h"
#include "render/film.h"

namespace rayscope::viewer {

namespace {

/// The image with another size, for a view whose tiles of that size are still to come.
RgbImage resized(const RgbImage& image, int width, int height) {
    RgbImage scaled(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            scaled.at(x, y) = image.at(x * image.width / width, y * image.height / height);
    return scaled;
}

/// Whether tiles of `next` may replace those of `shown` one by one.
bool refines(const TracedPicture& next, const TracedPicture& shown) {
    return previewDivisor(shown.request(), next.request()).value_or(1) > 1;
}

}  // namespace

RgbImage withBloom(const RgbImage& mean, const Settings& settings, const std::stop_token& stop) {
    return post::applyBloom(mean, settings, stop);
}

void ShownPicture::update(RenderControl& render, const Settings& display, double budgetSeconds) {
    changed_.clear();
    replaced_ = bloomChanged_ = false;
    takeWhole(render.whole());
    render.session().collect([this](const TileView& tile) { take(tile); }, budgetSeconds);
    if (const auto latest = render.session().picture();
        latest && source_ && latest->film() == source_->film())
        source_ = latest;  // the request that continues the film
    if (replaced_ || !changed_.empty()) {
        bloomOutdated_ = true;
        ++revision_;
    }
    updateBloom(display);
    if (!source_) return;
    request_ = source_->request();
    Settings& shown = request_->settings;
    shown = withDisplayOf(shown, bloomShown_ ? bloomImageSettings_ : display);
    shown.bloom = bloomShown_;
    shown.exposure = display.exposure;
    shown.tone = display.tone;
}

void ShownPicture::takeWhole(const std::optional<TracedPicture>& whole) {
    if (!whole || whole->film() == wholeFilm_) return;
    wholeFilm_ = whole->film();
    if (source_ && source_->film() == wholeFilm_) return;
    begin(*whole, RgbImage(wholeFilm_->width(), wholeFilm_->height()));
    render::Film::TileCopy copy;
    std::vector<Rgb> mean;
    for (int tile = 0; tile < wholeFilm_->tileCount(); ++tile) {
        wholeFilm_->read(tile, copy);
        mean.clear();
        for (const render::PixelSums& pixel : copy.pixels)
            mean.push_back(Rgb(pixel.radiance / static_cast<double>(copy.samples)));
        paste(tile, wholeFilm_->tileBounds(tile), mean, copy.samples);
    }
}

void ShownPicture::begin(const TracedPicture& picture, RgbImage image) {
    if (source_ && !isSameView(picture.request(), source_->request())) bloomShown_ = false;
    source_ = picture;
    image_ = std::move(image);
    samples_.assign(static_cast<std::size_t>(picture.film()->tileCount()), 0);
    replaced_ = true;
}

void ShownPicture::paste(int tile, const PixelBounds& bounds, std::span<const Rgb> mean, int samples) {
    const int width = bounds.x1 - bounds.x0;
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        const auto row = mean.begin() + static_cast<std::ptrdiff_t>(y - bounds.y0) * width;
        std::copy(row, row + width,
                  image_.pixels.begin() + static_cast<std::ptrdiff_t>(image_.index(bounds.x0, y)));
    }
    samples_[static_cast<std::size_t>(tile)] = samples;
    changed_.push_back(bounds);
}

void ShownPicture::take(const TileView& tile) {
    if (!source_) return;
    if (source_->film() != tile.picture.film()) {
        if (!refines(tile.picture, *source_)) return;
        begin(tile.picture, resized(image_, tile.imageWidth, tile.imageHeight));
    }
    const PixelBounds bounds{tile.x0, tile.x0 + tile.width, tile.y0, tile.y0 + tile.height};
    paste(source_->film()->tileAt(tile.x0, tile.y0), bounds, tile.mean, tile.samples);
}

void ShownPicture::updateBloom(const Settings& display) {
    if (auto bloomed = bloom_.poll();
        bloomed && source_ && display.bloom && isSameView(bloomed->request, source_->request())) {
        bloomImage_ = std::move(bloomed->image);
        bloomImageSettings_ = bloomed->request.settings;
        bloomShown_ = bloomChanged_ = true;
        ++revision_;
    }
    if (!display.bloom) {
        bloomOutdated_ = true;
        bloomChanged_ = std::exchange(bloomShown_, false);
        if (bloomChanged_) ++revision_;
        return;
    }
    if (withDisplayOf(bloomSettings_, display) != bloomSettings_) bloomOutdated_ = true;
    if (bloom_.busy() || !bloomOutdated_ || !source_) return;
    bloomSettings_ = display;
    bloomOutdated_ = false;
    RenderRequest request = source_->request();
    request.settings = withDisplayOf(request.settings, display);
    bloom_.start([image = image_, request = std::move(request)](const std::stop_token& stop, JobProgress&) {
        return Bloomed{withBloom(image, request.settings, stop), request};
    });
}

int ShownPicture::leastSamples() const {
    return samples_.empty() ? 0 : *std::min_element(samples_.begin(), samples_.end());
}

int ShownPicture::mostSamples() const {
    return samples_.empty() ? 0 : *std::max_element(samples_.begin(), samples_.end());
}

int ShownPicture::samplesOf(glm::ivec2 pixel) const {
    return samples_[static_cast<std::size_t>(source_->film()->tileAt(pixel.x, pixel.y))];
}

bool ShownPicture::isFull(const EditState& state, glm::ivec2 size) const {
    return source_ && isSameFrame(source_->request(), requestOf(state, size.x, size.y)) && leastSamples() > 0;
}

std::optional<Rgb> ShownPicture::radiance(const EditState& state, glm::ivec2 size, glm::ivec2 pixel) const {
    if (!source_ || !isSameFrame(source_->request(), requestOf(state, size.x, size.y))) return std::nullopt;
    if (samplesOf(pixel) == 0) return std::nullopt;
    return image_.at(pixel.x, pixel.y);
}

std::string samplesText(const StillPicture& picture) {
    const int least = picture.leastSamples(), most = picture.mostSamples();
    return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

std::string noticeOf(const ShownPicture& shown, const EditState& state, glm::ivec2 size, int mostSamples) {
    const RenderRequest* request = shown.request();
    if (request == nullptr) return "";
    const RenderRequest full = requestOf(state, size.x, size.y);
    const std::optional<int> divisor = previewDivisor(*request, full);
    if (!divisor) {
        if (request->scene != full.scene) return "previous scene";
        if (request->camera != full.camera) return "previous view";
        return isSameView(*request, full) ? "previous size" : "previous settings";
    }
    if (*divisor > 1) return fmt::format("preview: 1/{} of the resolution", *divisor);
    if (const int samples = shown.mostSamples(); samples > mostSamples)
        return fmt::format("previous picture with {} samples per pixel", samples);
    if (state.settings.bloom && !shown.bloomShown()) return "without bloom";
    return "";
}

}  // namespace rayscope::viewer
