#include <gtest/gtest.h>

#include <rayscope/scene.h>
#include <rayscope/settings.h>

namespace rayscope {
namespace {

SceneRequirements needsOf(const std::string& name) {
    Diagnostics notes;
    return requirementsOf(loadScene("builtin:" + name, notes));
}

TEST(InactiveSettings, ApplyToWhatTheSceneDoesNotContain) {
    const SceneRequirements triangle = needsOf("triangle"), area = needsOf("cornell-area");
    EXPECT_NE(inactiveReason(triangle, "max_depth"), "");
    EXPECT_EQ(inactiveReason(area, "max_depth"), "");
    EXPECT_NE(inactiveReason(area, "hard_shadows"), "");
    EXPECT_EQ(inactiveReason(triangle, "hard_shadows"), "");
    EXPECT_NE(inactiveReason(triangle, "soft_shadows"), "");
    EXPECT_EQ(inactiveReason(area, "soft_shadows"), "");
    EXPECT_EQ(inactiveReason(needsOf("spheres-dof"), "lens_samples"), "");
    EXPECT_EQ(inactiveReason(needsOf("environment"), "reflection_map"), "");
    EXPECT_EQ(inactiveReason(needsOf("cubes-transparent"), "transparency"), "");
}

TEST(InactiveSettings, OfAnEmptySceneAreAllThatDependOnTheScene) {
    std::vector<std::string> remaining;
    for (const std::string_view key : settingKeys())
        if (inactiveReason(SceneRequirements{}, key).empty()) remaining.emplace_back(key);
    const std::vector<std::string> expected = {
        "shading",    "spp",           "sampler",       "bvh",         "bvh_builder",
        "bvh_bins",   "bvh_max_level", "bvh_leaf_size", "bvh_refit",   "bvh_layout",
        "isa",        "bloom",         "bloom_filter",  "bloom_sigma", "bloom_threshold",
        "bloom_size", "bloom_scale",   "bloom_debug",   "bloom_stage", "exposure",
        "tone"};
    EXPECT_EQ(remaining, expected);
}

}  // namespace
}  // namespace rayscope
