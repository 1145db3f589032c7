#include <gtest/gtest.h>

#include "picture_labels.h"

namespace rayscope::viewer {
namespace {

TEST(LongPictureLabels, AreTrueInAHundredThousandRandomSteps) {
    for (unsigned seed = 100; seed < 110 && !testing::Test::HasFailure(); ++seed)
        checkRandomSequence(10000, seed);
}

}  // namespace
}  // namespace rayscope::viewer
