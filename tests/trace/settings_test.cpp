// Every setting changes the picture of a scene that uses all effects, or has a reason not to.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "bvh/binary_tree.h"
#include "image/srgb.h"
#include "post/display_transform.h"
#include "settings/table.h"
#include "support/all_effects_scene.h"
#include "support/tracing.h"
#include "trace/compile.h"

namespace rayscope::test {
namespace {

constexpr int kWidth = 20, kHeight = 14;

/// The image as 8-bit values.
std::vector<std::uint8_t> pictureOf(const Settings& settings) {
    const auto world = compileScene(allEffectsScene(), settings, kWidth, kHeight);
    RgbImage mean(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) mean.at(x, y) = Rgb(pixelMean(*world, 1, x, y, settings.spp));
    std::vector<std::uint8_t> bytes;
    for (const Rgb& pixel : post::applyDisplayTransform(mean, settings, true).pixels)
        for (int c = 0; c < 3; ++c) bytes.push_back(image::encodeByte(pixel[c], settings.tone));
    return bytes;
}

/// Settings on which the setting `key` depends.
Settings baseFor(std::string_view key) {
    Settings settings;
    settings.spp = 2;
    settings.glossy = settings.bloom = true;
    settings.glossySamples = settings.segmentSamples = settings.parallelogramSamples = 2;
    settings.bloomThreshold = 0.3f;
    settings.bloomDebug = key == "bloom_stage";
    return settings;
}

/// The ends of the range of a setting; sample counts are limited to 64 to save time.
std::array<std::string, 2> endsOf(const SettingInfo& info) {
    if (info.kind == "boolean") return {"false", "true"};
    if (info.key == "isa") return {"scalar", "auto"};  // the others depend on the machine
    if (info.kind == "choice") return {std::string(info.choices.front()), std::string(info.choices.back())};
    const bool samples = info.unit.starts_with("samples") || info.unit == "rays";
    const double highest =
        samples ? std::min(info.highest, info.unit == "samples per side" ? 8.0 : 64.0) : info.highest;
    return {fmt::format("{}", info.lowest), fmt::format("{}", highest)};
}

/// Settings that affect how an image is computed, not its values.
bool onlyShapesTheTree(std::string_view key) { return key.starts_with("bvh") || key == "isa"; }

/// A fingerprint of the BVH of the first motion group, after the group has been rotated.
std::vector<std::uint32_t> treeOf(const Settings& settings) {
    SceneDescription turned = allEffectsScene();
    for (MeshInstance& mesh : turned.meshes) mesh.transform.rotate += glm::vec3(20, 30, 40);
    const auto before = compileScene(std::move(turned), settings, kWidth, kHeight);
    trace::CompileRequest request;
    request.scene = std::make_shared<const SceneDescription>(allEffectsScene());
    request.camera = request.scene->cameras[0];
    request.settings = settings;
    const auto world = trace::compile(request, before.get());
    if (!world->motionGroups[0].accel) return {};
    const bvh::BinaryTree* tree = world->motionGroups[0].accel->binaryTree();
    std::vector<std::uint32_t> shape(tree->primitives.begin(), tree->primitives.end());
    const AccelSummary& summary = world->motionGroups[0].accel->summary();
    shape.push_back(static_cast<std::uint32_t>(tree->nodes.size()));
    shape.push_back(static_cast<std::uint32_t>(summary.wideNodes));
    shape.push_back(static_cast<std::uint32_t>(summary.isa));
    return shape;
}

TEST(EverySetting, ChangesThePictureOrOnlyTheBvh) {
    for (const SettingInfo& info : describeSettings()) {
        Settings low = baseFor(info.key), high = low;
        const auto [lowest, highest] = endsOf(info);
        assign(low, info.key, lowest);
        assign(high, info.key, highest);
        const bool changed = pictureOf(low) != pictureOf(high);
        if (onlyShapesTheTree(info.key)) {
            EXPECT_FALSE(changed) << info.key;
            EXPECT_NE(treeOf(low), treeOf(high)) << info.key;
        } else {
            EXPECT_TRUE(changed) << info.key << " from " << lowest << " to " << highest;
        }
    }
}

/// A setting that the table calls inactive has no effect.
TEST(EverySetting, HasNoEffectIfInactive) {
    Settings off;
    off.spp = 1;
    off.recursion = off.softShadows = off.hardShadows = off.textureMapping = off.environment =
        off.depthOfField = false;
    off.bvh = false;
    int inactive = 0;
    std::map<std::string_view, std::string_view> reasons;
    settings::forEachSetting([&](const auto& row) { reasons[row.text.key] = row.inactive(off); });
    for (const SettingInfo& info : describeSettings()) {
        if (reasons[info.key].empty()) continue;
        ++inactive;
        Settings low = off, high = off;
        const auto [lowest, highest] = endsOf(info);
        assign(low, info.key, lowest);
        assign(high, info.key, highest);
        EXPECT_EQ(pictureOf(low), pictureOf(high)) << info.key << ": " << reasons[info.key];
    }
    EXPECT_GT(inactive, 15);
}

}  // namespace
}  // namespace rayscope::test
