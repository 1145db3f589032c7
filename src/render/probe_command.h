#pragma once
// The command lines that repeat a request or one of its samples.
#include <rayscope/path.h>
#include <rayscope/render_session.h>

#include <optional>
#include <string>

#include "render/crash_report.h"

namespace rayscope::render {

/// `rayscope probe SCENE …`, quoted for a shell. It contains the camera and every setting that differ from
/// the scene file. What no option can express is as in the file: edited parts of the scene, and the lens of a
/// camera that was removed.
std::string probeCommand(const RenderRequest& request, const SampleId& sample);

/// `rayscope render SCENE …` without its outputs, which gives the same pixels with this number of samples
/// each; the scene is named without its folder. Nothing if there is no such command: the scene was edited, a
/// lens was removed, or the samples depend on a number of samples that was not reached.
std::optional<std::string> renderCommand(const RenderRequest& request, int samples);

/// The content of a crash report while this request is rendered.
CrashContext crashContextOf(const RenderRequest& request);

}  // namespace rayscope::render
