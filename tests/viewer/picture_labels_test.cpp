#include <gtest/gtest.h>

#include "picture_labels.h"

namespace rayscope::viewer {
namespace {

TEST(PictureLabels, AreTrueInAThousandRandomSteps) { checkRandomSequence(1000, 1); }

}  // namespace
}  // namespace rayscope::viewer
