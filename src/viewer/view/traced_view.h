#pragma once
#include <rayscope/render_session.h>
#include <chrono>
#include <future>
#include <optional>

#include "viewer/gl/shader.h"
#include "viewer/gl/texture.h"
#include "viewer/jobs/comparison.h"

namespace rayscope::viewer {

/// The ray-traced picture on its way to the screen: changed tiles go to a float texture; a shader applies
/// exposure and tone curve, so that those cost nothing. Bloom is computed beside the window's thread.
class TracedView {
  public:
    TracedView();
    ~TracedView();

    /// Takes what changed, for at most `budgetSeconds`. Returns the pixels of the image that are others now;
    /// nothing if none are.
    std::optional<PixelBounds> update(RenderSession& session, const Settings& settings, double budgetSeconds);

    /// Fills the bound target, which has this size.
    void draw(const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with the kept picture and this one, as they are to be compared.
    void drawComparison(const Comparison& comparison, const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with another image, as it is. The version tells whether it is another one than
    /// at the last call.
    void drawImage(const RgbImage& image, int version, glm::ivec2 size);

    /// Linear means as far as they have been taken; samples of a pixel's tile are not told apart.
    const RgbImage& image() const { return image_; }
    /// The same with bloom, if it is shown; the revision grows when this becomes another picture.
    const RgbImage& shownImage() const { return bloomShown_ ? bloomImage_ : image_; }
    int revision() const { return revision_; }
    bool computingBloom() const { return bloom_.valid(); }

  private:
    void take(const TileView& tile);
    void resize(int width, int height);
    bool updateBloom(const Settings& settings);
    /// With `other`, what the two differ by.
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

    /// Bloom of a copy of the image; done again when image or settings changed.
    std::future<RgbImage> bloom_;
    GlTexture bloomTexture_;
    RgbImage bloomImage_;
    Settings bloomSettings_;
    bool bloomOutdated_ = true, bloomShown_ = false;
};

}  // namespace rayscope::viewer
