#include "measure/many_rays.h"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t kSeams = 10'000'000, kSurfaces = 5'000'000;
#else  // with sanitizers
constexpr std::uint64_t kSeams = 100'000, kSurfaces = 50'000;
#endif

TEST(ManyRays, NoneLeaksAtASharedEdgeOrVertex) { EXPECT_GE(traceRaysAtSharedEdges(kSeams), kSeams); }
TEST(ManyRays, NoneHitsTheSurfaceItLeaves) { EXPECT_GE(traceSpawnedRays(kSurfaces), kSurfaces); }

}  // namespace
}  // namespace rayscope::test
