// Takes minutes to hours: $RAYSCOPE_LONG_RAYS rays, 10^8 if nothing is said.
#include <gtest/gtest.h>

#include <cstdlib>

#include "measure/many_rays.h"

namespace rayscope::test {
namespace {

std::uint64_t rayCount() {
    const char* wanted = std::getenv("RAYSCOPE_LONG_RAYS");
    return wanted ? std::strtoull(wanted, nullptr, 10) : 100'000'000;
}

void report(const char* what, std::uint64_t rays) {
    std::printf("%s: %llu rays\n", what, static_cast<unsigned long long>(rays));
    testing::Test::RecordProperty(what, std::to_string(rays));
}

TEST(LongRays, NoneLeaksAtASharedEdgeOrVertex) {
    report("without a leak", traceRaysAtSharedEdges(rayCount()));
}
TEST(LongRays, NoneHitsTheSurfaceItLeaves) { report("without a false hit", traceSpawnedRays(rayCount())); }

}  // namespace
}  // namespace rayscope::test
