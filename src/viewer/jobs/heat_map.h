#pragma once
#include <optional>

#include <rayscope/aov.h>
#include <rayscope/display.h>
#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// The distribution of the values of an image.
struct HeatStatistics {
    double lowest = 0.0, highest = 0.0, mean = 0.0;
    double upperPercentile = 0.0;     ///< 99 % of the pixels have at most this value
    std::vector<std::size_t> counts;  ///< histogram of equal bins from lowest to highest
};
/// Over the finite values of an image of one number per pixel.
HeatStatistics heatStatistics(const RgbImage& values);

/// The image as colours: `from` and below has the first, `to` and above the last.
RgbImage applyColorMap(const RgbImage& values, ColorMap map, double from, double to);

/// A per-pixel quantity (an AOV) in false colour, shown instead of the traced picture.
class HeatMap {
  public:
    bool shown = false;
    Aov aov = Aov::Nodes;
    ColorMap map = ColorMap::Spectrum;
    float from = 0.0f, to = 1.0f;  ///< values at the ends of the colours
    bool fitRange = true;          ///< fit `from` and `to` to the values of each new image
    int samples = 1;               ///< per pixel, over which costs are averaged

    /// Computes in the background what is shown. `film` is the one of the current picture.
    void update(std::shared_ptr<const trace::World> world, std::shared_ptr<const render::Film> film,
                int threads);
    bool busy() const { return job_.busy(); }
    /// Null unless shown and computed.
    const RgbImage* image() const { return shown && values_ ? &image_ : nullptr; }
    /// Whether image() is of the view of this world.
    bool isOf(const std::shared_ptr<const trace::World>& world) const { return world && world == world_; }
    const RgbImage* values() const { return values_ ? &*values_ : nullptr; }
    const HeatStatistics& statistics() const { return statistics_; }
    /// Applies map and range again.
    void recolor();
    /// Increases whenever image() changes.
    int version() const { return version_; }

  private:
    struct Source {
        std::shared_ptr<const trace::World> world;
        std::shared_ptr<const render::Film> film;
        Aov aov = Aov::Nodes;
        int samples = 0, filmSamples = 0;
        bool operator==(const Source&) const = default;
    };
    struct Computed {
        Source source;
        RgbImage values;
        HeatStatistics statistics;
    };
    static Computed compute(const Source& source, int threads, const std::stop_token& stop);

    Source requested_;  ///< of the latest job
    BackgroundJob<Computed> job_;
    std::optional<RgbImage> values_;
    std::shared_ptr<const trace::World> world_;  ///< of values_
    RgbImage image_;
    HeatStatistics statistics_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
