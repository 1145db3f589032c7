#pragma once
#include <optional>

#include "viewer/gl/shader.h"
#include "viewer/gl/texture.h"
#include "viewer/jobs/comparison.h"
#include "viewer/jobs/shown_picture.h"

namespace rayscope::viewer {

/// Displays the ray-traced picture: what changed is uploaded to a float texture; a shader applies exposure
/// and encoding, so changing those needs no upload.
class TracedView {
  public:
    TracedView();
    ~TracedView();

    /// Uploads what the last update of the picture changed. Returns the bounds of the changed pixels, if any.
    std::optional<PixelBounds> update(const ShownPicture& shown);

    /// Fills the bound target, which has this size.
    void draw(const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with the kept picture and this one, in the mode of the comparison.
    void drawComparison(const Comparison& comparison, const Settings& settings, glm::ivec2 size);

    /// Fills the bound target with another image, unchanged. It is uploaded when `version` changes.
    void drawImage(const RgbImage& image, int version, glm::ivec2 size);

  private:
    /// With `other`: the absolute difference of the two.
    void fill(const GlTexture& texture, glm::ivec2 size, float exposureFactor, bool clampOnly,
              const GlTexture* other = nullptr);
    const GlTexture& shownTexture() const { return bloomTexture_.empty() ? texture_ : bloomTexture_; }

    Shader shader_{"display"};
    GLuint emptyVertexArray_ = 0;
    GlTexture texture_, bloomTexture_;  ///< bloomTexture_ is empty without bloom

    GlTexture otherTexture_, keptTexture_;
    int otherVersion_ = -1, keptVersion_ = -1;
};

}  // namespace rayscope::viewer
