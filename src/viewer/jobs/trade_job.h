#pragma once
#include <rayscope/trade.h>

#include "viewer/jobs/background_job.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// The trade of speed for accuracy on the open scene, measured beside the window. A stop keeps what was
/// measured.
class TradeJob : public BackgroundJob<TradeResult> {
  public:
    float budget = 20.0f;  ///< seconds

    /// Measures a small picture of what `shown`, the size of the window's picture, shows.
    void start(const EditState& state, glm::ivec2 shown, int threads);

    /// The camera that the result is about.
    const CameraDescription& camera() const { return camera_; }

  private:
    CameraDescription camera_;
};

}  // namespace rayscope::viewer
