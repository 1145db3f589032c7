#pragma once
#include <rayscope/error_target.h>

#include "base/check_argument.h"

namespace rayscope::measure {

/// Throws std::invalid_argument, with the name of the member, if a value is out of range.
inline void checkTarget(const ErrorTarget& target) {
    base::checkArgument(target.error >= 0.0, "target: error is {}; expected at least 0", target.error);
    base::checkArgument(target.confidence >= 0.5 && target.confidence <= 0.9999,
                        "target: confidence is {}; expected 0.5 … 0.9999", target.confidence);
}

}  // namespace rayscope::measure
