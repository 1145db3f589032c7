#pragma once
#include <rayscope/render_session.h>
#include <optional>

#include "viewer/gl/shader.h"
#include "viewer/gl/texture.h"
#include "viewer/jobs/background_job.h"
#include "viewer/jobs/comparison.h"

namespace rayscope::viewer {

/// Displays the ray-traced picture: changed tiles are uploaded to a float texture; a shader applies exposure
/// and encoding, so changing those needs no upload. Bloom is computed in the background.
class TracedView {
  public:
    TracedView();
    ~TracedView();

    /// Collects changed tiles for at most `budgetSeconds`. Returns the bounds of the changed pixels, if any.
    std::optional<PixelBounds> update(RenderSession& session, const Settings& settings, double budgetSeconds);

    /// Fills the bound target, which has this size.
    void draw(const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with the kept picture and this one, in the mode of the comparison.
    void drawComparison(const Comparison& comparison, const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with another image, unchanged. It is uploaded when `version` changes.
    void drawImage(const RgbImage& image, int version, glm::ivec2 size);

    /// Linear means of the samples collected so far.
    const RgbImage& image() const { return image_; }
    /// The same with bloom, if it is shown; revision() increases whenever this changes.
    const RgbImage& shownImage() const { return bloomShown_ ? bloomImage_ : image_; }
    int revision() const { return revision_; }
    bool computingBloom() const { return bloom_.busy(); }

  private:
    void take(const TileView& tile);
    void resize(int width, int height);
    bool updateBloom(const Settings& settings);
    /// With `other`: the absolute difference of the two.
    void fill(const GlTexture& texture, glm::ivec2 size, float exposureFactor, bool clampOnly,
              const GlTexture* other = nullptr);
    void markChanged(const PixelBounds& bounds);

    Shader shader_{"display"};
    GLuint emptyVertexArray_ = 0;
    RgbImage image_;
    GlTexture texture_;
    std::optional<PixelBounds> changed_;  ///< since the last update()

    GlTexture otherTexture_, keptTexture_;
    int otherVersion_ = -1, keptVersion_ = -1;
    int revision_ = 0;

    BackgroundJob<RgbImage> bloom_;
    GlTexture bloomTexture_;
    RgbImage bloomImage_;
    Settings bloomSettings_;
    bool bloomOutdated_ = true, bloomShown_ = false;
};

}  // namespace rayscope::viewer
