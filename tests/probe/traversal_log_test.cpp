#include "probe/traversal_log.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "bvh/traversal/traversal_counts.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

std::shared_ptr<const trace::World> builtin(const std::string& name, Settings settings = {},
                                            bool moving = false) {
    Diagnostics notes;
    SceneDescription scene = loadScene("builtin:" + name, notes);
    if (moving) scene.spheres.at(0).motion = {0.0f, 0.5f, 0.0f};
    return test::compileScene(std::move(scene), settings, 32, 32);
}

Ray randomRay(std::mt19937& random) {
    std::uniform_real_distribution<float> coordinate(-1.5f, 1.5f);
    Ray ray;
    ray.origin = {coordinate(random), coordinate(random), 3.0f};
    ray.direction = glm::vec3(coordinate(random), coordinate(random), 0.0f) - ray.origin;
    return ray;
}

TEST(TraversalLog, HitsEqualThoseOfTheWorld) {
    for (const std::string name : {"monkey", "cornell", "spheres", "moving spheres"}) {
        const auto world = name == "moving spheres" ? builtin("spheres", {}, true) : builtin(name);
        std::mt19937 random(7);
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            const Ray ray = randomRay(random);
            Hit hit;
            const bool found = world->closestHit(ray, 0.25f, hit);
            hits += found;
            float nearest = ray.tMax;
            std::uint32_t primitive = kNoPrimitive;
            for (const probe::TraversalLog& log : probe::recordClosestHit(*world, ray, 0.25f)) {
                const probe::TraversalState end = probe::stateAfter(log, log.steps.size());
                ASSERT_EQ(end.closest, log.hit.primitive) << name;
                ASSERT_TRUE(end.stack.empty()) << "the stack is empty at the end";
                if (log.hit.primitive == kNoPrimitive) continue;
                ASSERT_EQ(end.bound, log.hit.t);
                if (log.hit.t < nearest || primitive == kNoPrimitive) {
                    nearest = log.hit.t;
                    primitive = log.hit.primitive + world->motionGroups[log.motionGroup].firstPrimitive;
                }
            }
            ASSERT_EQ(primitive, hit.primitive) << name << " ray " << i;
            if (found) {
                ASSERT_EQ(nearest, hit.t);
            }

            bool any = false;
            for (const probe::TraversalLog& log : probe::recordAnyHit(*world, ray, 0.25f))
                any |= log.hit.primitive != kNoPrimitive;
            ASSERT_EQ(any, world->anyHit(ray, 0.25f));
        }
        EXPECT_GT(hits, 3) << name;
    }
}

TEST(TraversalLog, StepsAgreeWithTheBoxes) {
    const auto world = builtin("monkey");
    std::mt19937 random(11);
    std::size_t culled = 0, pushed = 0;
    for (int i = 0; i < 200; ++i) {
        const probe::TraversalLog log = probe::recordClosestHit(*world, randomRay(random), 0.0f).at(0);
        std::size_t step = 0;
        for (const probe::TraversalStep& s : log.steps) {
            const probe::TraversalState before = probe::stateAfter(log, step++);
            EXPECT_EQ(s.bound, before.bound);
            const bool isOnStack = std::any_of(before.stack.begin(), before.stack.end(),
                                               [&](const auto& entry) { return entry.box == s.number; });
            switch (s.event) {
                case probe::TraversalEvent::Visited:
                    EXPECT_LE(s.t, before.bound);
                    // It is on top of the stack or a child of the node before.
                    EXPECT_TRUE(isOnStack ? before.stack.back().box == s.number
                                          : log.boxes[s.number].parent == before.current);
                    break;
                case probe::TraversalEvent::Pushed:
                    ++pushed;
                    EXPECT_EQ(log.boxes[s.number].parent, before.current);
                    // The sibling is visited next and is not farther away.
                    ASSERT_LT(step, log.steps.size());
                    EXPECT_EQ(log.steps[step].event, probe::TraversalEvent::Visited);
                    EXPECT_LE(log.steps[step].t, s.t);
                    break;
                case probe::TraversalEvent::Culled:
                    ++culled;
                    EXPECT_GT(s.t, before.bound);
                    break;
                case probe::TraversalEvent::Missed:
                    EXPECT_TRUE(std::isnan(s.t));
                    break;
                case probe::TraversalEvent::Hit:
                    EXPECT_LE(s.t, before.bound);
                    break;
                case probe::TraversalEvent::NoHit:
                    break;
                case probe::TraversalEvent::Filtered:
                    ADD_FAILURE() << "the binary tree has no float test";
            }
        }
    }
    EXPECT_GT(pushed, 100u);
    EXPECT_GT(culled, 10u);
}

TEST(WideTraversalLog, HitsEqualProductionRaysBitForBit) {
    for (const std::string name : {"monkey", "cornell", "spheres", "triangle"}) {
        const auto world = builtin(name);
        const bvh::WideTree* tree = world->motionGroups[0].accel->wideTree();
        ASSERT_NE(tree, nullptr);
        std::mt19937 random(23);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const Ray ray = randomRay(random);
            const probe::TraversalLog log = probe::recordClosestHit(*world, ray, 0.0f, BvhLayout::Wide).at(0);
            Hit hit;
            hits += world->motionGroups[0].accel->closestHit(ray, hit);
            ASSERT_EQ(std::memcmp(&hit, &log.hit, sizeof hit), 0) << name << " ray " << i;
            const bvh::TraversalCounts counts = bvh::countTraversals(*tree, {&ray, 1}, false);
            ASSERT_EQ(log.count(probe::TraversalEvent::Visited), counts.nodes + counts.leaves);
            ASSERT_EQ(log.tests(), counts.exact);
            ASSERT_EQ(log.count(probe::TraversalEvent::Filtered), counts.primitives - counts.exact);
            const probe::TraversalState end = probe::stateAfter(log, log.steps.size());
            ASSERT_TRUE(end.stack.empty()) << "the stack is empty at the end";
            ASSERT_EQ(end.closest, hit.primitive);

            const probe::TraversalLog any = probe::recordAnyHit(*world, ray, 0.0f, BvhLayout::Wide).at(0);
            ASSERT_EQ(any.hit.primitive != kNoPrimitive, world->anyHit(ray, 0.0f));
            const bvh::TraversalCounts anyCounts = bvh::countTraversals(*tree, {&ray, 1}, true);
            ASSERT_EQ(any.count(probe::TraversalEvent::Visited), anyCounts.nodes + anyCounts.leaves);
        }
        EXPECT_GT(hits, 20) << name;
    }
}

TEST(WideTraversalLog, ChildrenAreVisitedNearestFirst) {
    const auto world = builtin("monkey");
    std::mt19937 random(29);
    std::size_t culled = 0, pushed = 0, filtered = 0;
    for (int i = 0; i < 300; ++i) {
        const probe::TraversalLog log =
            probe::recordClosestHit(*world, randomRay(random), 0.0f, BvhLayout::Wide).at(0);
        std::size_t step = 0;
        for (const probe::TraversalStep& s : log.steps) {
            const probe::TraversalState before = probe::stateAfter(log, step++);
            ASSERT_EQ(s.bound, before.bound);
            const bool isOnStack = std::any_of(before.stack.begin(), before.stack.end(),
                                               [&](const auto& entry) { return entry.box == s.number; });
            if (s.event == probe::TraversalEvent::Visited && step > 1) {
                ASSERT_TRUE(isOnStack ? before.stack.back().box == s.number
                                      : log.boxes[s.number].parent == before.current);
                ASSERT_LE(s.t, before.bound);
                // Pushed siblings are not nearer.
                for (const auto& entry : before.stack)
                    if (!isOnStack && log.boxes[entry.box].parent == before.current) {
                        ASSERT_LE(s.t, entry.t);
                    }
            }
            if (s.event == probe::TraversalEvent::Culled) {
                ASSERT_GE(s.t, before.bound * (1.0f - 1e-6f));
            }
            pushed += s.event == probe::TraversalEvent::Pushed;
            culled += s.event == probe::TraversalEvent::Culled;
            filtered += s.event == probe::TraversalEvent::Filtered;
        }
        for (const probe::TraversalBox& box : log.boxes) {
            if (box.parent < 0) continue;
            const probe::TraversalBox& parent = log.boxes[static_cast<std::size_t>(box.parent)];
            ASSERT_TRUE(glm::all(glm::lessThanEqual(parent.lower, box.lower)));
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(parent.upper, box.upper)));
        }
    }
    EXPECT_GT(pushed, 100u);
    EXPECT_GT(culled, 10u);
    EXPECT_GT(filtered, 100u);
}

TEST(WideTraversalLog, NamesItsTree) {
    const auto world = builtin("cornell");
    const Ray ray{{0.0f, 0.0f, 3.0f}, {0.1f, -0.1f, -1.0f}};
    const probe::TraversalLog log = probe::recordClosestHit(*world, ray, 0.0f, BvhLayout::Wide).at(0);
    EXPECT_EQ(nlohmann::json::parse(probe::toJson(log))["layout"], "wide");
    EXPECT_NE(probe::toText(log).find("wide tree"), std::string::npos);
    EXPECT_NE(probe::toText(log).find("filters primitive"), std::string::npos);
    Settings settings;
    settings.bvhLayout = BvhLayout::Binary;
    EXPECT_TRUE(probe::recordClosestHit(*builtin("cornell", settings), ray, 0.0f, BvhLayout::Wide).empty());
}

TEST(TraversalLog, PrintsAsTextAndJson) {
    const auto world = builtin("cornell");
    Ray ray;
    ray.origin = {0.0f, 0.0f, 3.0f};
    ray.direction = {0.1f, -0.1f, -1.0f};
    const probe::TraversalLog log = probe::recordClosestHit(*world, ray, 0.0f).at(0);
    const std::string text = probe::toText(log);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<long>(log.steps.size()) + 3);
    const nlohmann::json j = nlohmann::json::parse(probe::toJson(log));
    ASSERT_EQ(j["steps"].size(), log.steps.size());
    EXPECT_EQ(j["boxes"][0]["node"], 0);
    EXPECT_EQ(j["steps"].back()["stack"].size(), 0u);
    EXPECT_EQ(j["hit"]["primitive"], log.hit.primitive);
}

TEST(TraversalLog, OfInvalidRaysAndEmptyScenes) {
    const auto empty = test::compileScene({}, {}, 4, 4);
    EXPECT_TRUE(probe::recordClosestHit(*empty, Ray{{0, 0, 0}, {0, 0, 1}}, 0.0f).empty());
    const auto world = builtin("triangle");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(probe::recordClosestHit(*world, Ray{{0, 0, 0}, {0, 0, 0}}, 0.0f).empty());
    EXPECT_TRUE(probe::recordAnyHit(*world, Ray{{nan, 0, 0}, {0, 0, 1}}, 0.0f).empty());
    Settings settings;
    settings.bvh = false;
    EXPECT_TRUE(
        probe::recordClosestHit(*builtin("triangle", settings), Ray{{0, 0, 0}, {0, 0, 1}}, 0.0f).empty());
    const probe::TraversalLog passing =
        probe::recordClosestHit(*world, Ray{{100, 100, 100}, {0, 0, 1}}, 0.0f).at(0);
    ASSERT_EQ(passing.steps.size(), 1u);
    EXPECT_EQ(passing.steps[0].event, probe::TraversalEvent::Missed);
}

}  // namespace
}  // namespace rayscope
