#pragma once
#include <cstddef>
#include <vector>

namespace rayscope::viewer {

/// The times from one frame to the next, of the latest frames that were not waiting for events.
class FrameTimes {
  public:
    void add(double seconds);
    /// The duration that the share `quantile` (0 … 1) of frames stay below, in seconds; 0 without frames.
    double quantile(double share) const;
    std::size_t count() const { return seconds_.size(); }
    void clear() { seconds_.clear(); }
    const std::vector<float>& latest() const { return seconds_; }

    static constexpr std::size_t kMaxCount = 240;

  private:
    std::vector<float> seconds_;
};

}  // namespace rayscope::viewer
