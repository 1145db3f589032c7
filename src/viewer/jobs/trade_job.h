#pragma once
#include <rayscope/trade.h>

#include "viewer/jobs/background_job.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// The speed-accuracy study of the open scene as a background job. A stop keeps the finished measurements.
class TradeJob : public BackgroundJob<TradeResult> {
  public:
    float budget = 20.0f;  ///< seconds

    /// Measures a small picture with the aspect ratio of `shown`, the size of the picture in the window.
    void start(const EditState& state, glm::ivec2 shown, int threads);

    /// The camera of the result.
    const CameraDescription& camera() const { return camera_; }

  private:
    CameraDescription camera_;
};

}  // namespace rayscope::viewer
