#pragma once
#include <rayscope/image.h>
#include <string>

namespace rayscope::cli {

/// Writes an error map: in false colour, white for `range`, in display formats, and the values in the others.
void writeErrorMap(const std::string& path, const Image<double>& map, double range);

}  // namespace rayscope::cli
