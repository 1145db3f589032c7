#pragma once
#include <rayscope/settings.h>
#include <rayscope/vector.h>
#include <cstdint>

namespace rayscope {

/// What a random number decides. Named, so that a feature which draws more shifts nobody else's numbers.
enum class Dim : std::uint32_t { Pixel, Lens, Time, Light, Glossy };

/// Names a vertex of the path tree: the camera is the root, each branch derives its own key.
struct PathKey {
    std::uint32_t value = 0;
    PathKey child(std::uint32_t branch) const;
    bool isRoot() const { return value == 0; }
};

/// The random numbers of one sample, as a pure function of (seed, pixel, sample index, vertex, dimension).
/// Drawing changes nothing, so the order in which numbers are drawn does not matter.
class SampleStream {
  public:
    /// `samplesPerPixel` is the number of indices over which a jittered pattern spreads its grid.
    SampleStream(SamplePattern pattern, std::uint64_t seed, int x, int y, int index, int samplesPerPixel);

    /// Point `k` of the `n` points that this sample takes of (dim, vertex, which), in [0, 1)^2. `which` tells
    /// lights apart. Unless the pattern is independent, the n points of one sample are stratified among
    /// themselves, and a single one over the samples of the pixel; Sobol points are stratified in both ways.
    glm::vec2 get2D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const;
    float get1D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const;

  private:
    glm::vec2 independent(std::uint64_t key, int k) const;
    glm::vec2 jittered(std::uint64_t key, int k, int n) const;
    struct Stratum {
        int cell, cells;
    };
    Stratum stratum(std::uint64_t key, int k, int n) const;

    SamplePattern pattern_;
    std::uint64_t pixelKey_;  ///< of seed and pixel
    int index_;
    int samplesPerPixel_;
};

}  // namespace rayscope
