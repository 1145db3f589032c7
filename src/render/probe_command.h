#pragma once
// The command line that repeats a sample of a request.
#include <rayscope/path.h>
#include <rayscope/render_session.h>

#include <string>

#include "render/crash_report.h"

namespace rayscope::render {

/// `rayscope probe SCENE …`, quoted for a shell. It contains the camera and every setting that differ from
/// the scene file. There is no option for an edited lens: the command uses the lens of the scene's camera of
/// that name.
std::string probeCommand(const RenderRequest& request, const SampleId& sample);

/// The content of a crash report while this request is rendered.
CrashContext crashContextOf(const RenderRequest& request);

}  // namespace rayscope::render
