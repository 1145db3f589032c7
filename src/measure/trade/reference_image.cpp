#include "measure/trade/reference_image.h"

#include <rayscope/diagnostics.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "math/vectors.h"
#include "measure/trade/content_hash.h"
#include "measure/trade/film_file.h"
#include "post/display_transform.h"
#include "render/ordered_tasks.h"
#include "render/render_pass.h"
#include "sampling/hash.h"
#include "trace/radiance.h"

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

int samplesOf(const std::array<std::unique_ptr<render::Film>, 2>& halves) {
    return std::min(halves[0]->completeSamples(), halves[1]->completeSamples());
}

/// As a film adds them up.
RgbSum radianceSum(const trace::World& world, std::uint64_t seed, int x, int y, int samples) {
    trace::NullObserver observer;
    RgbSum sum(0.0);
    for (int i = 0; i < samples; ++i) sum += trace::radiance(world, seed, {x, y, i}, observer).radiance;
    return sum;
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
    halves_ = emptyHalves();
}

ReferenceImage::Halves ReferenceImage::emptyHalves() const {
    const PixelBounds whole{0, request_.width, 0, request_.height};
    Halves halves;
    render::Film::requireMemory(whole, halves.size());
    for (auto& half : halves) half = std::make_unique<render::Film>(request_.width, request_.height, whole);
    return halves;
}

int ReferenceImage::samples() const { return samplesOf(halves_); }

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

/// Whether some pixels, about 2^18 samples of them, have the sums that rendering gives.
bool ReferenceImage::isRendered(const Halves& halves) const {
    constexpr int kMostPixels = 16, kSamples = 1 << 18;
    const int pixels = std::clamp(kSamples / std::max(1, samplesOf(halves)), 1, kMostPixels);
    std::atomic<bool> isEqual{true};
    render::runOrderedTasks(pixels, [&](int i) {
        const auto half = static_cast<std::size_t>(i) % halves.size();
        const std::uint64_t random = sampling::hashPair(kSeeds[half], static_cast<std::uint64_t>(i));
        const auto below = [](std::uint64_t value, int end) {
            return static_cast<int>(value % static_cast<std::uint64_t>(end));
        };
        const int x = below(random, request_.width), y = below(random >> 32, request_.height);
        int samples = 0;
        const render::PixelSums stored = halves[half]->sums(x, y, samples);
        if (stored.radiance != radianceSum(*world_, kSeeds[half], x, y, samples)) isEqual = false;
    });
    return isEqual;
}

bool ReferenceImage::load(const std::string& path) {
    Halves loaded = emptyHalves();
    if (samples() > 0 || !loadFilms(path, contentHash(), *loaded[0], *loaded[1])) return false;
    if (!workers_.run([&] { return isRendered(loaded); }))
        throw InputError("is not a film of this scene: pixels that were rendered anew differ", {path});
    halves_ = std::move(loaded);
    return true;
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
