#include "measure/trade/reference_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vectors.h"
#include "measure/trade/content_hash.h"
#include "measure/trade/film_file.h"
#include "post/display_transform.h"
#include "render/render_pass.h"

namespace rayscope::measure {

namespace {

/// Unlikely to equal a seed that a user chooses.
constexpr std::array<std::uint64_t, 2> kSeeds{0x7265666572656e41u, 0x7265666572656e42u};

/// The mean of `product(i)` over pixels and channels; non-finite pixels are left out.
template <class Product>
double meanOver(std::size_t pixels, Product&& product) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 p = product(i);
        const double value = p.x + p.y + p.z;
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    return count > 0 ? sum / (3.0 * static_cast<double>(count)) : std::numeric_limits<double>::quiet_NaN();
}

glm::dvec3 difference(const RgbImage& a, const RgbImage& b, std::size_t i) {
    return glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
}

}  // namespace

bool converges(const std::vector<std::pair<int, double>>& history) {
    constexpr double kConverging = 0.85;
    const std::size_t steps = history.size();
    return steps < 3 || history[steps - 1].second <= kConverging * history[steps - 3].second;
}

ReferenceImage::ReferenceImage(trace::CompileRequest request, render::ThreadArena& workers,
                               const trace::World* previous, const std::stop_token& stop)
    : request_(std::move(request)), workers_(workers) {
    world_ = workers_.run([&] { return trace::compile(request_, previous, stop); });
    for (auto& half : halves_)
        half = std::make_unique<render::Film>(request_.width, request_.height,
                                              PixelBounds{0, request_.width, 0, request_.height});
}

int ReferenceImage::samples() const {
    return std::min(halves_[0]->completeSamples(), halves_[1]->completeSamples());
}

bool ReferenceImage::extend(int samples, const std::stop_token& stop) {
    render::RenderCounters counters;
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        const bool complete = workers_.run([&] {
            return render::renderPass(*world_, kSeeds[i], *halves_[i], samples, {stop, {}}, counters);
        });
        if (!complete) return false;
    }
    return true;
}

RgbImage ReferenceImage::half(int which) const {
    return post::applyDisplayTransform(halves_[static_cast<std::size_t>(which)]->mean(), request_.settings,
                                       false);
}

RgbImage ReferenceImage::mean() const {
    RgbImage image = half(0);
    const RgbImage other = half(1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = Rgb(0.5 * (glm::dvec3(image.pixels[i]) + glm::dvec3(other.pixels[i])));
    return image;
}

double ReferenceImage::error() const {
    const RgbImage a = half(0), b = half(1);
    return 0.5 * std::sqrt(meanOver(a.pixels.size(), [&](std::size_t i) {
               const glm::dvec3 d = difference(a, b, i);
               return d * d;
           }));
}

long long ReferenceImage::nonFinitePixels() const {
    const RgbImage image = mean();
    return std::count_if(image.pixels.begin(), image.pixels.end(),
                         [](const Rgb& c) { return !math::isFinite(c); });
}

std::string ReferenceImage::contentHash() const { return filmContentHash(request_, *world_); }

bool ReferenceImage::load(const std::string& path) {
    return halves_[0]->completeSamples() == 0 && loadFilms(path, contentHash(), *halves_[0], *halves_[1]);
}

void ReferenceImage::save(const std::string& path) const {
    saveFilms(path, contentHash(), *halves_[0], *halves_[1]);
}

Settings referenceSettings(const Settings& settings) {
    Settings reference = settings;
    reference.maxDepth = 16;
    reference.sampler = SamplePattern::Sobol;
    reference.spp = 1 << 20;
    reference.glossySamples = reference.lensSamples = 1;
    if (settings.lightSampleCount == LightSampleCount::Fixed)
        reference.segmentSamples = reference.parallelogramSamples = 1;
    return reference;
}

double meanSquaredError(const RgbImage& image, const RgbImage& halfA, const RgbImage& halfB) {
    return meanErrorProduct(image, image, halfA, halfB);
}

double meanErrorProduct(const RgbImage& one, const RgbImage& other, const RgbImage& halfA,
                        const RgbImage& halfB) {
    return meanOver(one.pixels.size(), [&](std::size_t i) {
        return 0.5 * (difference(one, halfA, i) * difference(other, halfB, i) +
                      difference(one, halfB, i) * difference(other, halfA, i));
    });
}

}  // namespace rayscope::measure
