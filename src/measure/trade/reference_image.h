#pragma once
#include <array>
#include <memory>
#include <string>

#include "render/film.h"
#include "render/thread_arena.h"
#include "trace/compile.h"

namespace rayscope::measure {

/// The reference image of a study: two halves of the same picture with independent random numbers. Their
/// difference gives the error of their mean. Errors of other pictures are estimated without that error: for
/// an image I that is independent of the halves A and B, the expectation of mean((I − A)(I − B)) is the mean
/// squared error of I.
class ReferenceImage {
  public:
    /// The samples per pixel of the request are ignored; see referenceSettings().
    ReferenceImage(trace::CompileRequest request, render::ThreadArena& workers,
                   const trace::World* previous = nullptr, const std::stop_token& stop = {});

    const trace::World& world() const { return *world_; }
    /// Complete samples per pixel of each half.
    int samples() const;
    /// Adds samples until each half has `samples` per pixel. False if stopped; finished tiles are kept.
    bool extend(int samples, const std::stop_token& stop);

    /// RMSE of the mean of both halves, estimated from their difference, over pixels finite in both.
    double error() const;
    /// Each half, and the mean of both, linear, after bloom and before encoding.
    RgbImage half(int which) const;
    RgbImage mean() const;
    long long nonFinitePixels() const;

    /// Saves both halves to a file and loads them; see film_file.h. load() renders some pixels anew and
    /// compares them bit for bit. It returns false if the file does not exist, and throws InputError if it is
    /// not what save() of the same contentHash() wrote; nothing is changed then.
    std::string contentHash() const;
    bool load(const std::string& path);
    void save(const std::string& path) const;

  private:
    using Halves = std::array<std::unique_ptr<render::Film>, 2>;
    Halves emptyHalves() const;
    bool isRendered(const Halves& halves) const;

    trace::CompileRequest request_;
    render::ThreadArena& workers_;
    std::shared_ptr<const trace::World> world_;
    Halves halves_;
};

/// Whether the error of a reference falls as expected; `history` has an entry per doubling of the samples.
/// The error should halve with four times the samples; with fewer than three entries the result is true.
bool converges(const std::vector<std::pair<int, double>>& history);

/// The settings of the reference: those of the picture to which `settings` converge with unlimited samples
/// and reflections. Nothing is split, which converges fastest.
Settings referenceSettings(const Settings& settings);

/// Estimates of the mean squared error of an image, and of the mean product of the errors of two independent
/// images, whose expectation is the squared bias. Over pixels that are finite in all images.
double meanSquaredError(const RgbImage& image, const RgbImage& halfA, const RgbImage& halfB);
double meanErrorProduct(const RgbImage& one, const RgbImage& other, const RgbImage& halfA,
                        const RgbImage& halfB);

}  // namespace rayscope::measure
