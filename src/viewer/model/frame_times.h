#pragma once
#include <cstddef>
#include <vector>

namespace rayscope::viewer {

/// Frame times of the latest frames that did not wait for events.
class FrameTimes {
  public:
    void add(double seconds);
    /// The quantile (0 … 1) of the frame times, in seconds; 0 without frames.
    double quantile(double fraction) const;
    std::size_t count() const { return seconds_.size(); }
    void clear() { seconds_.clear(); }
    const std::vector<float>& latest() const { return seconds_; }

    static constexpr std::size_t kMaxCount = 240;

  private:
    std::vector<float> seconds_;
};

}  // namespace rayscope::viewer
