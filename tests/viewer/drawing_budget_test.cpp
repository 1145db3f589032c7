#include "viewer/view/drawing_budget.h"

#include <gtest/gtest.h>

namespace rayscope::viewer {
namespace {

TEST(DrawingBudget, LimitsOnlySoftwareRenderersDuringMotion) {
    EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_FALSE(isSoftwareRenderer("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"));
    EXPECT_FALSE(isSoftwareRenderer(""));
    EXPECT_EQ(drawingBudget(true, false), drawingBudget(false, false)) << "still pictures are drawn in full";
    EXPECT_EQ(drawingBudget(false, true), drawingBudget(false, false));
    const DrawingBudget least = drawingBudget(true, true), most = drawingBudget(false, true);
    EXPECT_LT(least.triangles, most.triangles);
    EXPECT_LT(least.boxes, most.boxes);
    EXPECT_LT(least.linePixels, most.linePixels);
    EXPECT_LT(least.maxWideLines, most.maxWideLines);
    EXPECT_GT(least.divisor, most.divisor);
}

TEST(DrawingBudget, ReportsWhatIsNotDrawn) {
    DrawnCounts counts;
    counts.lines = counts.linesDrawn = 7;
    counts.boxes = counts.boxesDrawn = 7;
    counts.triangles = counts.trianglesDrawn = 7;
    EXPECT_EQ(drawnText(counts), "");
    counts.linesDrawn = 3;
    EXPECT_EQ(drawnText(counts), "3 of 7 lines");
    counts.boxesDrawn = 2;
    counts.trianglesDrawn = 1;
    counts.divisor = 2;
    EXPECT_EQ(drawnText(counts),
              "3 of 7 lines, 2 of 7 boxes whole, 1 triangles for 7, 1/2 of the resolution");
}

}  // namespace
}  // namespace rayscope::viewer
