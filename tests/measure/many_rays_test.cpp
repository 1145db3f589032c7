#include "measure/many_rays.h"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t kSharedEdgeRays = 10'000'000, kSpawnedRays = 5'000'000;
#else  // with sanitizers
constexpr std::uint64_t kSharedEdgeRays = 100'000, kSpawnedRays = 50'000;
#endif

TEST(ManyRays, NoLeaksAtSharedEdgesAndVertices) {
    EXPECT_GE(traceRaysAtSharedEdges(kSharedEdgeRays), kSharedEdgeRays);
}
TEST(ManyRays, SpawnedRaysDoNotHitTheirOwnSurface) {
    EXPECT_GE(traceSpawnedRays(kSpawnedRays), kSpawnedRays);
}

}  // namespace
}  // namespace rayscope::test
