#pragma once
#include <cstdint>
#include <string>

#include "trace/compile.h"

namespace rayscope::measure {

/// 32 hexadecimal digits for everything that the samples of a film depend on: the content of the scene, the
/// settings that change samples, the camera and the size; and some traced samples, so that films of another
/// version of the tracer are not reused.
std::string filmContentHash(const trace::CompileRequest& request, const trace::World& world);

/// 32 hexadecimal digits for the bits of an image.
std::string imageContentHash(const RgbImage& image);

}  // namespace rayscope::measure
