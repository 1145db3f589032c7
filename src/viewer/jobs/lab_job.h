#pragma once
#include <rayscope/lab.h>

#include "viewer/jobs/scene_job.h"

namespace rayscope::viewer {

/// Numerical robustness (`rayscope lab`) of the open scene, measured in the background.
class LabJob : public SceneJob<LabResult> {
  public:
    bool quick = true, overlay = true;
    LabMethod shownMethod = LabMethod::Float;  ///< whose failures are drawn

    void start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads);
};

}  // namespace rayscope::viewer
