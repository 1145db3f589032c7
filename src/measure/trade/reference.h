#pragma once
#include <array>
#include <memory>
#include <string>

#include "measure/statistics/workers.h"
#include "render/film.h"
#include "trace/compile.h"

namespace rayscope::measure {

/// The truth, as near as time allows: two halves of the same picture with independent random numbers. The
/// difference of the halves tells their error, and products with both are free of it: for an image I that is
/// independent of the halves A and B, mean((I − A)(I − B)) has the expectation of the squared error of I.
class Reference {
  public:
    /// `settings` says what picture is the truth; their samples per pixel are ignored.
    Reference(trace::CompileRequest request, Workers& workers, const trace::World* previous = nullptr,
              const std::stop_token& stop = {});

    const trace::World& world() const { return *world_; }
    /// Samples that every pixel of both halves has.
    int samples() const;
    /// Brings every pixel of both halves to `samples`. False if it was stopped; what was traced is kept.
    bool extend(int samples, const std::stop_token& stop);

    /// RMSE of the mean of both halves, estimated from their difference, over pixels finite in both.
    double error() const;
    /// What can be compared with developed images: each half, and the mean of both.
    RgbImage half(int which) const;
    RgbImage mean() const;
    long long nonFinitePixels() const;

    /// A file of that name keeps the halves for another time. load() returns false, and changes nothing, if
    /// there is none or it is damaged.
    std::string contentHash() const;
    bool load(const std::string& path);
    void save(const std::string& path) const;

  private:
    trace::CompileRequest request_;
    Workers& workers_;
    std::shared_ptr<const trace::World> world_;
    std::array<std::unique_ptr<render::Film>, 2> halves_;
};

/// Whether a reference converges whose error was `history` at doubling samples: it should have halved with
/// four times as many. Fewer than three entries say nothing against it.
bool converges(const std::vector<std::pair<int, double>>& history);

/// The settings whose picture, with samples without end, is what `settings` ask for: reflections as deep as
/// they go, and nothing split, which converges fastest.
Settings referenceSettings(const Settings& settings);

/// Estimates of the mean squared error of an image, and of the product of the errors of two independent ones,
/// which is the square of what they have in common: their bias. Over pixels that are finite in all.
double meanSquaredError(const RgbImage& image, const RgbImage& halfA, const RgbImage& halfB);
double commonSquaredError(const RgbImage& one, const RgbImage& other, const RgbImage& halfA,
                          const RgbImage& halfB);

}  // namespace rayscope::measure
