#pragma once
// The options of `render` that set an error target, and the render that reaches it.
#include <rayscope/error_target.h>
#include <stop_token>
#include <string>

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

/// What ends a render to a target early, and how many threads it uses.
struct TargetLimits {
    double seconds = 0.0;  ///< 0: none
    int samples = 0;       ///< per pixel; 0: none
    int threads = 0;       ///< 0: one per core
    std::stop_token stop;
};

/// Renders until the target or a limit is reached and shows the progress.
ErrorTargetResult renderToTarget(const RenderRequest& request, const TargetOptions& options,
                                 const TargetLimits& limits, ProgressStyle style);

}  // namespace rayscope::cli
