// Takes minutes to hours: $RAYSCOPE_LONG_RAYS rays, by default 10^8.
#include <gtest/gtest.h>

#include <cstdlib>

#include "measure/many_rays.h"

namespace rayscope::test {
namespace {

std::uint64_t rayCount() {
    const char* requested = std::getenv("RAYSCOPE_LONG_RAYS");
    return requested ? std::strtoull(requested, nullptr, 10) : 100'000'000;
}

void report(const char* what, std::uint64_t rays) {
    std::printf("%s: %llu rays\n", what, static_cast<unsigned long long>(rays));
    testing::Test::RecordProperty(what, std::to_string(rays));
}

TEST(LongRays, NoLeaksAtSharedEdgesAndVertices) {
    report("without a leak", traceRaysAtSharedEdges(rayCount()));
}
TEST(LongRays, SpawnedRaysDoNotHitTheirOwnSurface) {
    report("without a false hit", traceSpawnedRays(rayCount()));
}

}  // namespace
}  // namespace rayscope::test
