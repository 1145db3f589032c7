#pragma once
#include <rayscope/settings.h>

namespace rayscope::test {

inline constexpr SamplePattern kPatterns[] = {SamplePattern::Independent, SamplePattern::Jittered,
                                              SamplePattern::Sobol};

inline const char* nameOf(SamplePattern pattern) {
    return pattern == SamplePattern::Independent ? "independent"
           : pattern == SamplePattern::Jittered  ? "jittered"
                                                 : "sobol";
}

}  // namespace rayscope::test
