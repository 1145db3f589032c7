#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "viewer/jobs/background_job.h"
#include "viewer/jobs/render_control.h"

namespace rayscope::viewer {

/// The image with the bloom of the settings, if it is on; the exposure is applied when it is drawn. Throws
/// Stopped.
RgbImage withBloom(const RgbImage& mean, const Settings& settings, const std::stop_token& stop = {});

/// The traced picture in the view, with what made it. It never has pixels of two views: a picture of another
/// view, or with fewer samples, replaces it only when it is whole, and only a preview is replaced tile by
/// tile. Bloom is computed in the background.
class ShownPicture {
  public:
    /// Takes over, for at most about `budgetSeconds`, what was traced since the last call. Bloom is that of
    /// `display`.
    void update(RenderControl& render, const Settings& display, double budgetSeconds);

    /// What the pixels are of; nothing before the first whole picture.
    const std::optional<TracedPicture>& source() const { return source_; }
    /// Its request, with the bloom, exposure and encoding with which it is shown; null without a picture.
    const RenderRequest* request() const { return request_ ? &*request_ : nullptr; }
    /// The samples of the pixels with the fewest and with the most of them; 0 for those of a preview that is
    /// being replaced.
    int leastSamples() const;
    int mostSamples() const;
    /// The samples of one pixel of image().
    int samplesOf(glm::ivec2 pixel) const;
    /// Whether the picture is that of the state in this size, and each pixel has a sample.
    bool isFull(const EditState& state, glm::ivec2 size) const;

    /// Linear means.
    const RgbImage& image() const { return image_; }
    /// The same with bloom, if it is on and computed.
    const RgbImage& displayed() const { return bloomShown_ ? bloomImage_ : image_; }
    bool bloomShown() const { return bloomShown_; }
    bool computingBloom() const { return bloom_.busy(); }
    /// The mean of a pixel of a picture of this size; nothing if the pixel has no sample or the picture
    /// another size or view.
    std::optional<Rgb> radiance(const EditState& state, glm::ivec2 size, glm::ivec2 pixel) const;

    /// Increases whenever displayed() changes.
    int revision() const { return revision_; }
    /// Whether the last update() replaced image() as a whole, and the rectangles that it changed otherwise.
    bool replaced() const { return replaced_; }
    const std::vector<PixelBounds>& changedTiles() const { return changed_; }
    bool bloomChanged() const { return bloomChanged_; }

  private:
    void takeWhole(const std::optional<TracedPicture>& whole);
    void take(const TileView& tile);
    void begin(const TracedPicture& picture, RgbImage image);
    void paste(int tile, const PixelBounds& bounds, std::span<const Rgb> mean, int samples);
    void updateBloom(const Settings& display);

    std::optional<TracedPicture> source_;
    std::optional<RenderRequest> request_;
    std::shared_ptr<const render::Film> wholeFilm_;  ///< of the latest whole picture that was taken over
    RgbImage image_;
    std::vector<int> samples_;  ///< of each tile of the film, as far as it is in image_
    std::vector<PixelBounds> changed_;
    bool replaced_ = false, bloomChanged_ = false;
    int revision_ = 0;

    struct Bloomed {
        RgbImage image;
        RenderRequest request;  ///< of the picture, with its bloom
    };
    BackgroundJob<Bloomed> bloom_;
    RgbImage bloomImage_;
    Settings bloomImageSettings_;
    Settings bloomSettings_;  ///< of the latest job
    bool bloomOutdated_ = true, bloomShown_ = false;
};

/// "16", or "4 to 8" where pixels differ.
std::string samplesText(const StillPicture& picture);

/// What the picture in the view is, if it is not the complete picture of the state in this size: "previous
/// view", "preview: 1/8 of the resolution" …; otherwise empty. The complete picture has at most `mostSamples`
/// samples per pixel.
std::string noticeOf(const ShownPicture& shown, const EditState& state, glm::ivec2 size, int mostSamples);

}  // namespace rayscope::viewer
