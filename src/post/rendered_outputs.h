#pragma once
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <stop_token>
#include <string>

namespace rayscope::post {

/// The image files of a render, as writeRenderedImage() (display.h) makes them, but with bloom applied once
/// for all, and for a user who may wait for the end of the program: after a stop bloom is left out unless it
/// is complete, and files are not compressed.
class RenderedOutputs {
  public:
    /// Applies bloom. `mean` must outlive the object.
    RenderedOutputs(const RgbImage& mean, const Settings& settings, std::stop_token stop);

    /// The settings that the images show: without bloom if that was left out.
    const Settings& settings() const { return settings_; }
    bool lacksBloom() const { return lacksBloom_; }

    void write(const std::string& path, const ImageMetadata& metadata) const;
    /// The file for a suffix such as ".png".
    std::string encode(const std::string& suffix, const ImageMetadata& metadata) const;

  private:
    template <class Use>
    auto withImageFor(const std::string& path, Use use) const;

    const RgbImage& mean_;
    Settings settings_;
    std::stop_token stop_;
    RgbImage bloomed_;  ///< empty without bloom
    bool lacksBloom_ = false;
};

}  // namespace rayscope::post
