#pragma once
// The options of `render` that ask for an accuracy, and the rendering that serves them.
#include <rayscope/error_target.h>

#include "cli/interrupt.h"
#include "cli/progress.h"

namespace rayscope::cli {

class OptionList;

struct TargetOptions {
    double error = 0.0, confidence = 0.95;
    std::string metric = "rmse";
    bool worstTile = false, adaptive = false;

    void addTo(OptionList& list);
    bool wanted() const { return error > 0.0; }
};

/// Renders until the target or a limit is reached, telling how far it is. `maxSamples` is 0 for no limit.
ErrorTargetResult renderToTarget(const RenderRequest& request, const TargetOptions& options, double timeLimit,
                                 int maxSamples, int threads, const InterruptGuard& interrupt,
                                 ProgressStyle style);

}  // namespace rayscope::cli
