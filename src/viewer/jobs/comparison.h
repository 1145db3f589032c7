#pragma once
#include <rayscope/compare.h>
#include <rayscope/render_session.h>
#include <chrono>
#include <memory>
#include <optional>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

enum class CompareMode { Wipe, Flip, Difference };

/// A kept picture, A, and the current one, B. Both have the same random numbers, so all differences are due
/// to the settings.
class Comparison {
  public:
    /// How the two are shown.
    struct View {
        bool shown = false;
        CompareMode mode = CompareMode::Wipe;
        float divider = 0.5f;     ///< of the width; A is on its left
        bool flipped = false;     ///< mode Flip shows A
        float brightness = 8.0f;  ///< what differences are multiplied with
        int version = 0;          ///< increases whenever A changes
        bool operator==(const View&) const = default;
    };
    View view;

    struct Kept {
        StillPicture picture;
        std::shared_ptr<const RgbImage> image;  ///< its means with the bloom of its settings
    };
    void keep(StillPicture picture);
    void discard();
    const Kept* a() const { return kept_ ? &*kept_ : nullptr; }
    /// Whether A is to be drawn.
    bool visible() const { return kept_ && view.shown; }

    /// Measures the error of B against A in the background if either has changed; `revision` identifies the
    /// picture B. While B is not `complete` it is measured every few seconds only.
    void update(const RgbImage& b, int revision, bool complete, float exposure);
    bool busy() const { return job_.busy(); }
    /// Of B against A; null until measured, or if the pictures differ in size.
    const ErrorMeasures* metrics() const { return metrics_ ? &*metrics_ : nullptr; }
    /// Whether metrics() is of a picture B that was complete and is still shown.
    bool metricsAreFinal() const { return metrics_ && final_; }

  private:
    using Clock = std::chrono::steady_clock;

    std::optional<Kept> kept_;
    std::optional<ErrorMeasures> metrics_;
    struct Pair {
        int version = -1, revision = -1;  ///< of A, and of B
        float exposure = 0.0f;
        bool operator==(const Pair&) const = default;
    };
    struct Measured {
        Pair pair;
        ErrorMeasures metrics;
    };
    BackgroundJob<Measured> job_;
    Pair measured_;  ///< the pictures that metrics_ are of
    bool final_ = false;
    Clock::time_point measuredAt_{};
};

/// The settings in which two requests differ, as "spp 4 -> 16"; "camera", "scene" where those differ, too.
std::vector<std::string> differencesOf(const RenderRequest& a, const RenderRequest& b);

}  // namespace rayscope::viewer
