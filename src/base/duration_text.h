#pragma once
#include <string>

namespace rayscope::base {

/// "0.42 s", "32 s", "5 min 32 s", "2 h 05 min" or "44 d 20 h".
std::string durationText(double seconds);

}  // namespace rayscope::base
