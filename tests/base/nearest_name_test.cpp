#include "base/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace rayscope {
namespace {

using Names = std::array<std::string_view, 3>;
constexpr Names kNames{"max_depth", "shading", "spp"};

TEST(NearestName, ForgivesSlipsOfThePen) {
    EXPECT_EQ(nearestName("max_dept", kNames), "max_depth");    // a letter left out
    EXPECT_EQ(nearestName("maxx_depth", kNames), "max_depth");  // one too many
    EXPECT_EQ(nearestName("max-depth", kNames), "max_depth");   // a wrong one
    EXPECT_EQ(nearestName("shadign", kNames), "shading");       // two swapped
}

TEST(NearestName, OffersNothingForAWordFromElsewhere) {
    EXPECT_EQ(nearestName("photon_count", kNames), "");
    EXPECT_EQ(didYouMean("photon_count", kNames), "");
    EXPECT_EQ(nearestName("x", std::span<const std::string_view>{}), "");
}

TEST(NearestName, TakesTheNearerOfTwo) {
    constexpr std::array<std::string_view, 2> names{"bvh_bins", "bvh_binz"};
    EXPECT_EQ(nearestName("bvh_binz", names), "bvh_binz");
}

TEST(NearestName, WritesChoicesAsASentenceWould) {
    EXPECT_EQ(joinChoices(kNames), "max_depth, shading or spp");
    EXPECT_EQ(joinChoices(std::span(kNames).first(2)), "max_depth or shading");
    EXPECT_EQ(joinChoices(std::span(kNames).first(1)), "max_depth");
    EXPECT_EQ(joinChoices({}), "");
    EXPECT_EQ(didYouMean("sp", kNames), " (did you mean 'spp'?)");
}

}  // namespace
}  // namespace rayscope
