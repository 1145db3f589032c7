#include "base/nearest_name.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace rayscope {
namespace {

using Names = std::array<std::string_view, 3>;
constexpr Names kNames{"max_depth", "shading", "spp"};

TEST(NearestName, FindsTypos) {
    EXPECT_EQ(base::nearestName("max_dept", kNames), "max_depth");    // deletion
    EXPECT_EQ(base::nearestName("maxx_depth", kNames), "max_depth");  // insertion
    EXPECT_EQ(base::nearestName("max-depth", kNames), "max_depth");   // substitution
    EXPECT_EQ(base::nearestName("shadign", kNames), "shading");       // transposition
}

TEST(NearestName, ReturnsNothingForUnrelatedNames) {
    EXPECT_EQ(base::nearestName("photon_count", kNames), "");
    EXPECT_EQ(base::didYouMean("photon_count", kNames), "");
    EXPECT_EQ(base::nearestName("x", std::span<const std::string_view>{}), "");
}

TEST(NearestName, ReturnsTheNearest) {
    constexpr std::array<std::string_view, 2> names{"bvh_bins", "bvh_binz"};
    EXPECT_EQ(base::nearestName("bvh_binz", names), "bvh_binz");
}

TEST(NearestName, JoinsChoices) {
    EXPECT_EQ(base::joinChoices(kNames), "max_depth, shading or spp");
    EXPECT_EQ(base::joinChoices(std::span(kNames).first(2)), "max_depth or shading");
    EXPECT_EQ(base::joinChoices(std::span(kNames).first(1)), "max_depth");
    EXPECT_EQ(base::joinChoices({}), "");
    EXPECT_EQ(base::didYouMean("sp", kNames), " (did you mean 'spp'?)");
}

TEST(NearestName, LongNamesAndListsAreCheapAndShort) {
    const std::string name(1'000'000, 'm'), other(1'000'000, 'n');
    const std::vector<std::string_view> one{other};
    EXPECT_EQ(base::nearestName(name, one), "");
    EXPECT_EQ(base::nearestName("spp", one), "");
    EXPECT_EQ(base::joinChoices(one), fmt::format("{}…", other.substr(0, 64)));
    // Cut between characters, not within one.
    const std::string letters(63, 'e'), accents = fmt::format("{}é and more", letters);
    EXPECT_EQ(base::joinChoices(std::vector<std::string_view>{accents}), fmt::format("{}…", letters));
    const std::vector<std::string_view> many(1000, "spp");
    EXPECT_EQ(base::joinChoices(many).substr(17 * 5), "spp or 982 more");
}

}  // namespace
}  // namespace rayscope
