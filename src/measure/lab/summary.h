#pragma once
#include <rayscope/lab.h>

namespace rayscope::measure {

/// Finds the ranges of a result whose testPoints are complete and in order, and what is to be remarked.
void summarize(LabResult& result);

}  // namespace rayscope::measure
