#pragma once
#include <rayscope/lab.h>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// The numerical robustness test of the open scene as a background job. A stop keeps the finished test
/// points.
class LabJob : public BackgroundJob<LabResult> {
  public:
    bool quick = true, overlay = true;
    LabMethod shownMethod = LabMethod::Float;  ///< whose failures are drawn

    void start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads);
};

}  // namespace rayscope::viewer
