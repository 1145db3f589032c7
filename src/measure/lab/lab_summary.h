#pragma once
#include <rayscope/lab.h>

namespace rayscope::measure {

/// Fills ranges, meshOffset and remarks of a result with sorted test points.
void summarizeLab(LabResult& result);

}  // namespace rayscope::measure
