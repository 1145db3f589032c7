#pragma once
#include <rayscope/lab.h>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// The laboratory on the open scene, beside the window. A stop keeps what was measured.
class LabJob : public BackgroundJob<LabResult> {
  public:
    bool quick = true, overlay = true;
    LabMethod shownMethod = LabMethod::Float;  ///< whose failures are drawn

    void start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads);
};

}  // namespace rayscope::viewer
