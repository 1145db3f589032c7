#pragma once
#include <rayscope/settings.h>
#include <rayscope/vector.h>
#include <cstdint>

namespace rayscope::sampling {

/// What a random number decides. Named, so that a feature which draws more shifts nobody else's numbers.
enum class Dim : std::uint32_t { Pixel, Lens, Time, Light, Glossy };

/// Names a vertex of the path tree: the camera is the root, each branch derives its own key.
struct PathKey {
    std::uint32_t value = 0;
    PathKey child(std::uint32_t branch) const;
    bool isRoot() const { return value == 0; }
};

/// The n points that one sample takes for one purpose, in [0, 1)^2. Unless the pattern is independent they
/// are stratified among themselves, and a single one over the samples of the pixel; Sobol points are
/// stratified in both ways.
class SamplePoints {
  public:
    glm::vec2 get2D(int k = 0) const;
    float get1D(int k = 0) const;

  private:
    friend class SampleStream;
    struct Stratum {
        int cell, cells;
    };
    Stratum stratum(std::uint64_t key, int k) const;
    glm::vec2 independent(std::uint64_t key, int k) const;
    glm::vec2 jittered(int k) const;
    std::uint32_t shuffled(int k) const;

    SamplePattern pattern_ = SamplePattern::Independent;
    std::uint64_t key_ = 0;  ///< of everything that names the points but k
    std::uint32_t shuffle_ = 0;
    int dimension_ = 0;  ///< of the Sobol sequence
    int index_ = 0, samplesPerPixel_ = 1, n_ = 1;
};

/// The random numbers of one sample, as a pure function of (seed, pixel, sample index, vertex, dimension).
/// Drawing changes nothing, so the order in which numbers are drawn does not matter.
class SampleStream {
  public:
    /// `samplesPerPixel` is the number of indices over which a jittered pattern spreads its grid.
    SampleStream(SamplePattern pattern, std::uint64_t seed, int x, int y, int index, int samplesPerPixel);

    /// The n points of this sample for (dim, vertex, which); `which` tells lights apart.
    SamplePoints points(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int n = 1) const;

    /// Point k of them.
    glm::vec2 get2D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const {
        return points(dim, vertex, which, n).get2D(k);
    }
    float get1D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const {
        return points(dim, vertex, which, n).get1D(k);
    }

  private:
    SamplePattern pattern_;
    std::uint64_t pixelKey_;  ///< of seed and pixel
    int index_;
    int samplesPerPixel_;
};

}  // namespace rayscope::sampling
