#pragma once
#include <rayscope/settings.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <span>

namespace rayscope::sampling {

/// The purpose of a random number. Random numbers are addressed by purpose, so that a feature that needs more
/// of them does not change those of others.
enum class Dim : std::uint32_t { Pixel, Lens, Time, Light, Glossy };

/// Identifies a vertex of the path tree: the camera is the root, each branch derives its own key.
struct PathKey {
    std::uint32_t value = 0;
    PathKey child(std::uint32_t branch) const;
    bool isRoot() const { return value == 0; }
};

/// Whether the points of a pattern depend on the number of samples per pixel, which must then be known in
/// advance: the jittered grid does; the others are prefixes of one infinite sequence.
constexpr bool dependsOnSampleCount(SamplePattern pattern) { return pattern == SamplePattern::Jittered; }

/// The n points in [0, 1)^2 that one sample takes for one purpose. Jittered points are stratified among
/// themselves if n > 1, else over the samples of the pixel; Sobol points in both ways.
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
    std::uint64_t key_ = 0;  ///< hash of everything that identifies the points, except k
    std::uint32_t shuffle_ = 0;
    int dimension_ = 0;  ///< of the Sobol sequence
    int index_ = 0, samplesPerPixel_ = 1, n_ = 1;
};

/// The random numbers of one sample: a pure function of (seed, pixel, sample index, vertex, dimension). There
/// is no state, so the order of calls does not matter.
class SampleStream {
  public:
    /// `samplesPerPixel` is the number of strata of a jittered pattern.
    SampleStream(SamplePattern pattern, std::uint64_t seed, int x, int y, int index, int samplesPerPixel);

    /// The stream of another sample of the same pixel.
    SampleStream withIndex(int index) const {
        SampleStream other = *this;
        other.index_ = index;
        return other;
    }

    /// The n points of this sample for (dim, vertex, which); `which` is the number of the light.
    SamplePoints points(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int n = 1) const;

    /// Point k of points(dim, vertex, which, n).
    glm::vec2 get2D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const {
        return points(dim, vertex, which, n).get2D(k);
    }
    float get1D(Dim dim, PathKey vertex = {}, std::uint32_t which = 0, int k = 0, int n = 1) const {
        return points(dim, vertex, which, n).get1D(k);
    }

    /// get2D(dim) of each stream. Neighbours of the same pixel share most of the work.
    static void get2D(Dim dim, std::span<const SampleStream> streams, std::span<glm::vec2> values);

  private:
    SamplePattern pattern_;
    std::uint64_t pixelKey_;  ///< hash of seed and pixel
    int index_;
    int samplesPerPixel_;
};

}  // namespace rayscope::sampling
