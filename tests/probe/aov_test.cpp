#include <rayscope/aov.h>
#include "math/vectors.h"

#include <gtest/gtest.h>

#include <set>

#include <rayscope/probe.h>

#include "bvh/layout/wide_tree.h"
#include "probe/traversal_log.h"
#include "render/film.h"
#include "support/test_scenes.h"
#include "trace/compile.h"

namespace rayscope {
namespace {

std::vector<RgbImage> render(const trace::World& world, std::vector<Aov> wanted, int samples = 2,
                             int threads = 0) {
    AovRequest request{world};
    request.samples = samples;
    request.threads = threads;
    request.seed = 3;
    return renderAovs(request, wanted);
}

TEST(Aov, SurfaceValuesMatchTheFirstHit) {
    const auto world = test::compileBuiltin("cornell", 20);
    const auto images = render(*world, {Aov::Normal, Aov::Depth, Aov::Uv, Aov::Primitive, Aov::Material});
    int hits = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            const Ray ray = world->camera.pinholeRay(glm::dvec2(x, y) + 0.5);
            Hit hit;
            if (!world->closestHit(ray, 0.0f, hit)) {
                EXPECT_EQ(images[1].at(x, y).x, 0.0f);
                EXPECT_EQ(images[3].at(x, y).x, -1.0f);
                continue;
            }
            ++hits;
            EXPECT_NEAR(glm::length(images[0].at(x, y)), 1.0f, 1e-5f);
            EXPECT_LE(images[1].at(x, y).x, hit.t * 1.0001f);
            EXPECT_EQ(images[3].at(x, y).x, static_cast<float>(hit.primitive));
            EXPECT_GE(images[4].at(x, y).x, 0.0f);
        }
    EXPECT_GT(hits, 60);
}

/// The primitives of the leaves that a traversal visits up to its end; in the binary tree those tested up to
/// the first hit of an any-hit query.
std::size_t testedPrimitives(const trace::World& world, const probe::TraversalLog& log) {
    if (log.layout == BvhLayout::Binary) return log.tests();
    const bvh::WideTree& tree = *world.motionGroups[log.motionGroup].accel->wideTree();
    std::size_t count = 0;
    for (const probe::TraversalStep& step : log.steps) {
        if (step.event != probe::TraversalEvent::Visited || !log.boxes[step.number].leaf) continue;
        const std::uint32_t leaf = log.boxes[step.number].node;
        if (leaf >= tree.blocks.size()) {
            ++count;  // a sphere
        } else {
            const auto& triangles = tree.blocks[leaf].primitive;  // unused lanes repeat the last triangle
            count += std::set<std::uint32_t>(std::begin(triangles), std::end(triangles)).size();
        }
    }
    return count;
}

/// Counters agree with the logs of all rays of the replayed samples, in the layout that production rays
/// traverse.
TEST(Aov, CountsAgreeWithTraversalLogs) {
    for (const BvhLayout layout : {BvhLayout::Wide, BvhLayout::Binary})
        for (const std::string name : {"cornell-area", "cubes-transparent", "monkey", "spheres"}) {
            Settings settings;
            settings.bvhLayout = layout;
            const auto world = test::compileBuiltin(name, 8, settings);
            const auto images = render(*world, {Aov::Nodes, Aov::Triangles, Aov::Rays}, 2);
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) {
                    std::size_t nodes = 0, tests = 0, rays = 0;
                    for (int index = 0; index < 2; ++index) {
                        const RayTree tree = probeSample(*world, 3, {x, y, index});
                        const auto count = [&](const std::vector<probe::TraversalLog>& logs) {
                            ++rays;
                            for (const probe::TraversalLog& log : logs) {
                                nodes += log.count(probe::TraversalEvent::Visited);
                                tests += testedPrimitives(*world, log);
                            }
                        };
                        for (const RayNode& node : tree.nodes)
                            if (node.end != RayEnd::BelowSurface)
                                count(probe::recordClosestHit(*world, node.ray, tree.time, layout));
                        for (const ShadowRay& shadow : tree.shadowRays)
                            if (shadow.visibility != Visibility::FacingAway)
                                count(probe::recordAnyHit(*world, shadow.ray, tree.time, layout));
                    }
                    EXPECT_EQ(images[0].at(x, y).x, static_cast<float>(nodes) / 2.0f)
                        << name << x << " " << y;
                    EXPECT_EQ(images[1].at(x, y).x, static_cast<float>(tests) / 2.0f);
                    EXPECT_EQ(images[2].at(x, y).x, static_cast<float>(rays) / 2.0f);
                }
        }
}

/// The counts do not depend on whether the binary tree is kept for display.
TEST(Aov, CountsNeedNoBinaryTree) {
    Diagnostics notes;
    trace::CompileRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene("builtin:monkey", notes));
    request.camera = request.scene->cameras.front();
    request.width = request.height = 8;
    request.keepBinaryTrees = false;
    const auto world = trace::compile(request);
    ASSERT_EQ(world->motionGroups[0].accel->binaryTree(), nullptr);
    const auto images = render(*world, {Aov::Nodes, Aov::Triangles});
    double nodes = 0.0, tests = 0.0;
    for (const Rgb& pixel : images[0].pixels) nodes += static_cast<double>(pixel.x);
    for (const Rgb& pixel : images[1].pixels) tests += static_cast<double>(pixel.x);
    EXPECT_GE(nodes, 64.0) << "every camera ray visits the root";
    EXPECT_GT(tests, 0.0);
}

TEST(Aov, EqualForAnyNumberOfThreads) {
    const auto world = test::compileBuiltin("teapot", 20);
    const std::vector<Aov> wanted{Aov::Normal, Aov::Nodes, Aov::Triangles, Aov::Rays, Aov::NonFinite};
    const auto one = render(*world, wanted, 2, 1), many = render(*world, wanted, 2, 7);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(one[i].pixels, many[i].pixels);
}

TEST(Aov, FilmValuesAreItsMoments) {
    Diagnostics notes;
    RenderRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene("builtin:cornell-area", notes));
    request.camera = request.scene->cameras.front();
    request.settings.spp = 8;
    request.width = request.height = 16;
    RenderSession session(1);
    session.submit(request);
    ASSERT_EQ(session.wait(60.0), RenderState::Done);
    AovRequest aovs{*session.picture()->world()};
    const auto film = session.picture()->film();
    aovs.film = film.get();
    const std::vector<Aov> wanted{Aov::Samples, Aov::Variance, Aov::Error};
    const auto images = renderAovs(aovs, wanted);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            double mean = 0.0, squares = 0.0;
            for (int i = 0; i < 8; ++i)
                mean +=
                    math::luminance(probeSample(*session.picture()->world(), 0, {x, y, i}).radiance) / 8.0;
            for (int i = 0; i < 8; ++i)
                squares += std::pow(
                    math::luminance(probeSample(*session.picture()->world(), 0, {x, y, i}).radiance) - mean,
                    2);
            EXPECT_EQ(images[0].at(x, y).x, 8.0f);
            EXPECT_NEAR(images[1].at(x, y).x, squares / 7.0, 1e-6 + 1e-4 * squares);
            EXPECT_NEAR(images[2].at(x, y).x, std::sqrt(squares / 56.0), 1e-4);
        }
}

TEST(Aov, UnknownNameSuggestsTheNearest) {
    EXPECT_EQ(aovNamed("nodes"), Aov::Nodes);
    for (const AovInfo& info : aovTable()) EXPECT_EQ(&infoOf(info.aov), &info);
    try {
        aovNamed("nodess");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("'nodes'"), std::string::npos) << error.what();
    }
}

TEST(Aov, EmptySceneAndStop) {
    const auto world = test::compileScene({}, {}, 5, 5);
    const auto images = render(*world, {Aov::Normal, Aov::Nodes, Aov::Rays});
    EXPECT_EQ(images[1].at(2, 2).x, 0.0f);
    EXPECT_EQ(images[2].at(2, 2).x, 1.0f);
    std::stop_source stop;
    stop.request_stop();
    AovRequest request{*world};
    request.stop = stop.get_token();
    const std::vector<Aov> wanted{Aov::Depth};
    EXPECT_THROW(renderAovs(request, wanted), Stopped);
}

}  // namespace
}  // namespace rayscope
