#pragma once
#include <future>
#include <optional>

#include "post/color_map.h"
#include "probe/aov.h"
#include "trace/world.h"

namespace rayscope::viewer {

/// How many pixels have which value, and the range that the colours span.
struct HeatStatistics {
    double lowest = 0.0, highest = 0.0, mean = 0.0;
    double upperPercentile = 0.0;     ///< 99 % of the pixels lie at or below it
    std::vector<std::size_t> counts;  ///< in equal steps from lowest to highest
};
/// Over the finite values of an image of one number per pixel.
HeatStatistics heatStatistics(const RgbImage& values);

/// The image as colours: `from` and below has the first, `to` and above the last.
RgbImage applyColorMap(const RgbImage& values, post::ColorMap map, double from, double to);

/// A picture of what pixels cost or how certain they are, in place of the traced one.
class HeatMap {
  public:
    ~HeatMap() { stop_.request_stop(); }

    bool shown = false;
    probe::Aov aov = probe::Aov::Nodes;
    post::ColorMap map = post::ColorMap::Spectrum;
    float from = 0.0f, to = 1.0f;  ///< values at the ends of the colours
    bool fitRange = true;          ///< to the values, anew for each picture
    int samples = 1;               ///< per pixel, that are counted

    /// Computes beside the window what is to be shown. `film` is the one of the current picture.
    void update(std::shared_ptr<const trace::World> world, std::shared_ptr<const render::Film> film,
                int threads);
    bool busy() const { return pending_.valid(); }
    /// Null until there is one.
    const RgbImage* image() const { return shown && values_ ? &image_ : nullptr; }
    const RgbImage* values() const { return values_ ? &*values_ : nullptr; }
    const HeatStatistics& statistics() const { return statistics_; }
    /// Applies map and range again.
    void recolor();
    /// Grows when image() becomes another one.
    int version() const { return version_; }

  private:
    struct Source {
        std::shared_ptr<const trace::World> world;
        std::shared_ptr<const render::Film> film;
        probe::Aov aov = probe::Aov::Nodes;
        int samples = 0, filmSamples = 0;
        bool operator==(const Source&) const = default;
    };
    Source computedSource_, pendingSource_;
    std::future<RgbImage> pending_;
    std::stop_source stop_;
    std::optional<RgbImage> values_;
    RgbImage image_;
    HeatStatistics statistics_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
