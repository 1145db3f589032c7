#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include <rayscope/probe.h>
#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

/// A pane of half opacity before a mirror before a white wall behind the camera.
std::shared_ptr<const trace::World> paneAndMirror() {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(1.0f, 0.0f, 0.0f), Rgb(0.0f), 1.0f, 0.5f),
                       test::material(Rgb(0.0f), Rgb(0.5f)), test::material(Rgb(1.0f))};
    scene.meshes = {test::quad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, 0),
                    test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 1),
                    test::quad({-9, -9, 9}, {18, 0, 0}, {0, 18, 0}, 2)};
    scene.lights = {test::pointLight({0, 0, 4})};
    Settings settings;
    settings.shading = false;
    settings.hardShadows = false;
    return test::compileScene(scene, settings, 11, 11);
}

TEST(RayTree, RecordsLayersReflectionsAndTheirParents) {
    const RayTree tree = probeSample(*paneAndMirror(), 0, {5, 5, 0});
    // camera → pane; on to the mirror; reflected to the pane's back; on to the wall.
    ASSERT_EQ(tree.nodes.size(), 4u);
    const RayKind kinds[] = {RayKind::Camera, RayKind::Transparent, RayKind::Reflection,
                             RayKind::Transparent};
    const int parents[] = {-1, 0, 1, 2}, depths[] = {0, 0, 1, 1};
    const double throughputs[] = {1.0, 0.5, 0.25, 0.125};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(tree.nodes[i].kind, kinds[i]) << i;
        EXPECT_EQ(tree.nodes[i].parent, parents[i]) << i;
        EXPECT_EQ(tree.nodes[i].depth, depths[i]) << i;
        EXPECT_EQ(tree.nodes[i].throughput.x, throughputs[i]) << i;
        EXPECT_TRUE(tree.nodes[i].hit) << i;
    }
    EXPECT_EQ(tree.nodes[1].end, RayEnd::Reflected);
    EXPECT_EQ(tree.nodes[3].end, RayEnd::Absorbed);
    EXPECT_EQ(tree.radiance, RgbSum(0.5 + 0.125 + 0.125, 0.125, 0.125));
    EXPECT_EQ(tree.shadowRays.size(), 4u);
}

TEST(RayTree, PrintsAsTextAndJson) {
    const auto world = paneAndMirror();
    const RayTree tree = probeSample(*world, 0, {5, 5, 0});
    const std::string text = toText(tree, *world);
    EXPECT_NE(text.find("transparent ray"), std::string::npos) << text;
    EXPECT_NE(text.find("reflection ray"), std::string::npos);
    const nlohmann::json j = nlohmann::json::parse(toJson(tree, *world));
    EXPECT_EQ(j["nodes"].size(), 4u);
    EXPECT_EQ(j["nodes"][2]["parent"], 1);
    EXPECT_EQ(j["radiance"][0], 0.75);
    EXPECT_EQ(j["nodes"][0]["hit"]["object"], "mesh 0 'quad'");
}

TEST(RayTree, RadianceAlongASegmentIncludesItsChildren) {
    const auto world = paneAndMirror();
    const RayTree tree = probeSample(*world, 0, {5, 5, 0});
    const std::vector<RgbSum> along = radianceAlong(tree);
    EXPECT_EQ(along[0], tree.radiance);
    // Through the first pane: the mirror alone, and in it the pane's back and the wall.
    EXPECT_EQ(along[1], RgbSum(0.5, 0.25, 0.25));
    EXPECT_EQ(along[3], RgbSum(1.0));
    EXPECT_EQ(surfaceColor(tree.nodes[0]), RgbSum(1.0, 0.0, 0.0)) << "undimmed by its opacity";
    EXPECT_EQ(tree.nodes[0].opacity, 0.5);
}

TEST(RayTree, ExportsObjLines) {
    const auto world = paneAndMirror();
    const RayTree tree = probeSample(*world, 0, {5, 5, 0});
    std::istringstream obj(toObj(tree, 10.0f));
    std::size_t vertices = 0, lines = 0, groups = 0;
    for (std::string line; std::getline(obj, line);) {
        vertices += line.starts_with("v ");
        groups += line.starts_with("g ");
        if (!line.starts_with("l ")) continue;
        std::size_t a = 0, b = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "l %zu %zu", &a, &b), 2);
        EXPECT_EQ(a, 2 * lines + 1);
        EXPECT_EQ(b, 2 * lines + 2);
        ++lines;
    }
    EXPECT_EQ(lines, tree.nodes.size() + tree.shadowRays.size());
    EXPECT_EQ(vertices, 2 * lines);
    EXPECT_GE(groups, 3u);
}

TEST(RayTree, IsWrittenInTheFormatOfTheSuffix) {
    const test::TemporaryFolder folder;
    const auto world = paneAndMirror();
    const RayTree tree = probeSample(*world, 0, {5, 5, 0});
    for (const char* name : {"rays.json", "rays.obj", "rays.OBJ"})
        writeRayTree(folder.file(name), tree, *world, 10.0f);
    EXPECT_EQ(test::readText(folder / "rays.json"), toJson(tree, *world));
    EXPECT_EQ(test::readText(folder / "rays.obj"), toObj(tree, 10.0f));
    EXPECT_EQ(test::readText(folder / "rays.OBJ"), toObj(tree, 10.0f));
    EXPECT_THROW(writeRayTree(folder.file("rays.txt"), tree, *world, 10.0f), InputError);
    EXPECT_THROW(writeRayTree(folder.file("nowhere/rays.obj"), tree, *world, 10.0f), InputError);
}

TEST(RayTree, MissIsOneNode) {
    SceneDescription scene;
    const auto world = test::compileScene(scene, {}, 4, 4);
    const RayTree tree = probeSample(*world, 0, {1, 1, 0});
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes[0].end, RayEnd::Missed);
    EXPECT_FALSE(tree.nodes[0].hit);
    EXPECT_FALSE(toText(tree, *world).empty());
}

TEST(RayTree, InvalidTreesThrow) {
    const auto world = test::compileScene({}, {}, 4, 4);
    RayTree tree;
    EXPECT_NO_THROW(toText(tree, *world));
    RayNode node;
    node.parent = 77;
    tree.nodes = {node};
    EXPECT_THROW(toText(tree, *world), std::invalid_argument);
    EXPECT_THROW(toJson(tree, *world), std::invalid_argument);
    EXPECT_THROW(radianceAlong(tree), std::invalid_argument);
    node.parent = -1;
    node.hit = true;
    node.material = 99;
    tree.nodes = {node};
    EXPECT_THROW(toText(tree, *world), std::invalid_argument);
    EXPECT_THROW(toJson(tree, *world), std::invalid_argument);
}

}  // namespace
}  // namespace rayscope
