#pragma once
#include <cstdint>
#include <string>

#include "trace/compile.h"

namespace rayscope::measure {

/// 32 hexadecimal digits that stand for everything a film is a function of: the content of the scene, the
/// settings that reach the film, the camera and the size; and some traced samples, so that a program that
/// traces differently does not take over old films.
std::string filmContentHash(const trace::CompileRequest& request, const trace::World& world);

}  // namespace rayscope::measure
