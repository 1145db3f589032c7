#pragma once
#include <rayscope/render_session.h>
#include <rayscope/vector.h>
#include <string>

namespace rayscope::cli {

// Each throws UsageError that names the option and the expected form.

/// "X,Y,Z" as three finite numbers.
glm::vec3 parseVector(const std::string& option, const std::string& text);

/// "WxH" or "X,Y" as two whole numbers of at least `lowest`.
glm::ivec2 parsePair(const std::string& option, const std::string& text, char separator, int lowest);

/// "X0,X1,Y0,Y1" as four whole numbers of at least 0.
PixelBounds parseBounds(const std::string& option, const std::string& text);

}  // namespace rayscope::cli
