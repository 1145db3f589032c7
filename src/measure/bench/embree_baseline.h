#pragma once
// Embree with the same geometry and rays, where it is installed.
#include <rayscope/accel.h>
#include <memory>
#include <span>

namespace rayscope::measure {

enum class EmbreeQuery { Single, Packet16, Stream };

/// An Embree scene of medium build quality.
class EmbreeBaseline {
  public:
    static bool isAvailable();

    /// Throws std::runtime_error where Embree is not available.
    EmbreeBaseline(const AccelInput& input, bool robust, int threads);
    ~EmbreeBaseline();
    EmbreeBaseline(const EmbreeBaseline&) = delete;
    EmbreeBaseline& operator=(const EmbreeBaseline&) = delete;

    double buildSeconds() const;
    std::size_t bytes() const;

    void closestHits(EmbreeQuery query, bool coherent, std::span<const Ray> rays, std::span<Hit> hits) const;
    void anyHits(EmbreeQuery query, bool coherent, std::span<const Ray> rays,
                 std::span<std::uint8_t> occluded) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rayscope::measure
