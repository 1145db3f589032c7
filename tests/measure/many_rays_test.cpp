#include "measure/many_rays.h"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t kSeams = 1'000'000, kSurfaces = 1'000'000;
#else  // with sanitizers
constexpr std::uint64_t kSeams = 200'000, kSurfaces = 50'000;
#endif

TEST(ManyRays, NoneLeaksAtASharedEdgeOrVertex) { EXPECT_GE(shootAtSeams(kSeams), kSeams); }
TEST(ManyRays, NoneHitsTheSurfaceItLeaves) { EXPECT_GE(leaveSurfaces(kSurfaces), kSurfaces); }

}  // namespace
}  // namespace rayscope::test
