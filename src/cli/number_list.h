#pragma once
#include <rayscope/vector.h>
#include <string>
#include <vector>

namespace rayscope::cli {

/// "1,2.5,-3" as `count` finite numbers. Throws UsageError that names the option and the expected
/// form.
std::vector<double> parseNumbers(const std::string& option, const std::string& text, char separator,
                                 int count);

glm::vec3 parseVector(const std::string& option, const std::string& text);
/// "WxH" or "X,Y" as two whole numbers of at least `lowest`.
glm::ivec2 parsePair(const std::string& option, const std::string& text, char separator, int lowest);

}  // namespace rayscope::cli
