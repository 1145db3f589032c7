#pragma once
#include <rayscope/trade.h>

#include "viewer/jobs/scene_job.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// Speed against accuracy (`rayscope trade`) for the open scene, measured in the background.
class TradeJob : public SceneJob<TradeResult> {
  public:
    float budget = 20.0f;  ///< seconds

    /// Measures on a small picture with the aspect ratio of `shown`, the size of the window's picture.
    void start(const EditState& state, glm::ivec2 shown, int threads);

    /// The camera of the result.
    const CameraDescription& camera() const { return camera_; }

  private:
    CameraDescription camera_;
};

}  // namespace rayscope::viewer
