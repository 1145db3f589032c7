// A hit depends on ray and geometry only: every builder, query and observed traversal equals brute force.
#include <gtest/gtest.h>

#include "bvh/meshes.h"
#include "bvh/traversal/traverse.h"
#include "bvh/traversal_cases.h"

namespace rayscope::test {
namespace {

struct BuilderCase {
    BuildSettings settings;
    const char* name;
    bool withAllTraversals;  ///< or with the best kernels only
};

std::vector<BuilderCase> builderCases() {
    std::vector<BuilderCase> cases;
    const auto add = [&](const char* name, BvhBuilder builder, int leafSize, int maxLevel, int bins) {
        BuildSettings settings;
        settings.builder = builder;
        settings.leafSize = leafSize;
        settings.maxLevel = maxLevel;
        settings.bins = bins;
        cases.push_back({settings, name, leafSize == 4});
    };
    add("median", BvhBuilder::Median, 1, 64, 32);
    add("median, leaves of 4", BvhBuilder::Median, 4, 64, 32);
    add("sweep", BvhBuilder::Sah, 1, 64, 32);
    add("sweep, leaves of 4", BvhBuilder::Sah, 4, 64, 32);
    add("2 bins", BvhBuilder::SahBinned, 1, 64, 2);
    add("32 bins", BvhBuilder::SahBinned, 4, 64, 32);
    add("4096 bins", BvhBuilder::SahBinned, 8, 64, 4096);
    add("level 3", BvhBuilder::SahBinned, 4, 3, 8);
    add("high", BvhBuilder::SahReinsertion, 4, 64, 32);
    add("high, leaves of 1", BvhBuilder::SahReinsertion, 1, 64, 32);
    add("high, level 3", BvhBuilder::SahReinsertion, 8, 3, 8);
    add("level 0", BvhBuilder::Sah, 4, 0, 8);
    return cases;
}

/// Not the null observer: the traversal with all events.
struct IgnoringObserver : bvh::NullTraversalObserver {};

TEST(SameHit, EveryBuilderAndQueryEqualsBruteForce) {
    for (const TestGeometry& scene : edgeCaseScenes()) {
        const std::vector<Ray> rays = edgeCaseRays(scene, 1500, 99);
        std::vector<Hit> expected(rays.size());
        std::vector<std::uint8_t> occluded(rays.size());
        std::size_t hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits += bvh::closestHitBruteForce(scene.input(), rays[i], expected[i]);
            occluded[i] = bvh::anyHitBruteForce(scene.input(), rays[i]);
            ASSERT_EQ(occluded[i] != 0, expected[i].primitive != kNoPrimitive)
                << scene.name << ": " << text(rays[i]);
        }
        EXPECT_GT(hits, rays.size() / 50) << scene.name << ": too few hits";
        for (const BuilderCase& builder : builderCases())
            for (const TraversalCase& traversalCase :
                 builder.withAllTraversals ? traversalCases() : std::vector{traversalCases().back()}) {
                const Accel accel = build(scene, builder.settings, traversalCase);
                std::vector<Hit> batch(rays.size());
                std::vector<std::uint8_t> anyBatch(rays.size(), 7);
                accel.closestHits(rays, batch);
                accel.anyHits(rays, anyBatch);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const auto where = [&] {
                        return scene.name + ", " + builder.name + ", " + traversalCase.name + ": " +
                               text(rays[i]);
                    };
                    Hit hit;
                    const bool found = accel.closestHit(rays[i], hit);
                    ASSERT_TRUE(sameHit(hit, expected[i]))
                        << where() << "\nfound " << text(hit) << "\nbrute " << text(expected[i]);
                    ASSERT_EQ(found, hit.primitive != kNoPrimitive) << where();
                    ASSERT_TRUE(sameHit(batch[i], hit)) << where();
                    ASSERT_EQ(accel.anyHit(rays[i]), occluded[i] != 0) << where();
                    ASSERT_EQ(anyBatch[i], occluded[i]) << where();
                    if (i % 16 == 0 && accel.binaryTree()) {
                        IgnoringObserver observer;
                        Hit observed;
                        const bvh::BinaryTree& tree = *accel.binaryTree();
                        ASSERT_EQ(bvh::traverse<bvh::QueryKind::Closest>(tree, scene.input(), rays[i],
                                                                         observed, observer),
                                  found);
                        ASSERT_TRUE(sameHit(observed, hit)) << where();
                        ASSERT_EQ(bvh::traverse<bvh::QueryKind::Any>(tree, scene.input(), rays[i], observed,
                                                                     observer),
                                  found)
                            << where();
                    }
                }
            }
    }
}

/// An observer without all hooks does not compile.
struct OnlyVisits {
    void visit(std::uint32_t, float) {}
};
static_assert(!bvh::TraversalObserver<OnlyVisits>);
static_assert(bvh::TraversalObserver<IgnoringObserver>);

/// The events of each node of a tree.
struct EventLog : bvh::NullTraversalObserver {
    struct Events {
        int hits = 0, misses = 0, culls = 0, pushes = 0, visits = 0;
    };
    std::vector<Events> nodes;
    std::vector<std::uint32_t> tests;

    explicit EventLog(std::size_t count) : nodes(count) {}
    void intersect(std::uint32_t node, float) { ++nodes[node].hits; }
    void miss(std::uint32_t node, float) { ++nodes[node].misses; }
    void cull(std::uint32_t node, float) { ++nodes[node].culls; }
    void push(std::uint32_t node, float) { ++nodes[node].pushes; }
    void visit(std::uint32_t node, float) { ++nodes[node].visits; }
    void test(std::uint32_t primitive, bool, const bvh::kernel::HitData&, float) {
        tests.push_back(primitive);
    }
};

TEST(SameHit, EventsOfEveryNodeAreConsistent) {
    const TestGeometry scene = soup(2000, 0.2, 17);
    const Accel accel = build(scene, {}, traversalCases().back());
    const bvh::BinaryTree& tree = *accel.binaryTree();
    int visited = 0;
    for (const Ray& ray : edgeCaseRays(scene, 500, 3))
        for (const bool any : {false, true}) {
            EventLog log(tree.nodes.size());
            Hit hit;
            const bool found =
                any ? bvh::traverse<bvh::QueryKind::Any>(tree, scene.input(), ray, hit, log)
                    : bvh::traverse<bvh::QueryKind::Closest>(tree, scene.input(), ray, hit, log);
            for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
                const EventLog::Events& events = log.nodes[node];
                visited += events.visits;
                ASSERT_LE(events.hits + events.misses, 1) << "a box is tested once";
                ASSERT_LE(events.visits + events.culls, events.hits);
                ASSERT_LE(events.pushes, events.hits);
                // Only an any-hit query leaves nodes on the stack.
                if (!any || !found) {
                    ASSERT_EQ(events.visits + events.culls, events.hits);
                }
                if (events.visits == 0 || tree.nodes[node].isLeaf()) continue;
                for (const std::uint32_t child : {tree.nodes[node].first, tree.nodes[node].first + 1})
                    ASSERT_EQ(log.nodes[child].hits + log.nodes[child].misses, 1);
            }
            if (found) {
                EXPECT_NE(std::find(log.tests.begin(), log.tests.end(), hit.primitive), log.tests.end());
            }
        }
    EXPECT_GT(visited, 1000);
}

TEST(SameHit, EqualDistanceSelectsTheSmallerNumber) {
    TestGeometry scene = soup(1, 1.0, 2);
    for (int i = 0; i < 50; ++i) scene.triangles.push_back(scene.triangles[0]);
    const glm::vec3 middle = (scene.corner(0, 0) + scene.corner(0, 1) + scene.corner(0, 2)) / 3.0f;
    const Ray ray{middle + glm::vec3(1, 2, 3), glm::vec3(-1, -2, -3)};
    for (const BuilderCase& builder : builderCases())
        for (const TraversalCase& traversalCase : traversalCases()) {
            const Accel accel = build(scene, builder.settings, traversalCase);
            std::vector<Hit> hits(20);
            accel.closestHits(std::vector<Ray>(20, ray), hits);
            for (const Hit& hit : hits)
                EXPECT_EQ(hit.primitive, 0u) << builder.name << ", " << traversalCase.name;
            Hit hit;
            ASSERT_TRUE(accel.closestHit(ray, hit));
            EXPECT_EQ(hit.primitive, 0u) << builder.name << ", " << traversalCase.name;
        }
}

TEST(SameHit, BatchesOfAnySizeEqualSingleRays) {
    const TestGeometry scene = soup(3000, 0.1, 5);
    const std::vector<Ray> rays = edgeCaseRays(scene, 1500, 6);
    for (const TraversalCase& traversalCase : traversalCases()) {
        const Accel accel = build(scene, {}, traversalCase);
        for (const std::size_t size : {0, 1, 2, 3, 7, 8, 9, 15, 16, 17, 33, 100, 511, 512, 513, 1025})
            for (std::size_t begin = 0; begin < rays.size() - size; begin += 700) {
                const std::span<const Ray> some(rays.data() + begin, size);
                std::vector<Hit> hits(size);
                std::vector<std::uint8_t> occluded(size, 7);
                accel.closestHits(some, hits);
                accel.anyHits(some, occluded);
                for (std::size_t i = 0; i < size; ++i) {
                    Hit hit;
                    accel.closestHit(some[i], hit);
                    ASSERT_TRUE(sameHit(hit, hits[i]))
                        << traversalCase.name << ", " << size << ": " << text(some[i]);
                    ASSERT_EQ(occluded[i], accel.anyHit(some[i])) << traversalCase.name << ", " << size;
                }
            }
    }
}

/// Coherent rays: parallel, from a common origin, or towards a common point; some end before the hit.
std::vector<Ray> coherentRays(const Ray& ray, double reach, double spread, int count, Random& random) {
    const int kind = random.integer(3);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 apart(glm::dvec3(random.inCube()) * spread * reach *
                              static_cast<double>(glm::length(ray.direction)));
        Ray like = ray;
        if (kind != 0) like.origin += apart;
        if (kind != 1) like.direction += glm::vec3(glm::dvec3(apart) / reach) * (kind == 2 ? -1.0f : 1.0f);
        if (random.integer(4) == 0) like.tMax = static_cast<float>(reach * random.real(0.5, 1.5));
        rays.push_back(like);
    }
    return rays;
}

TEST(SameHit, CoherentRaysEqualBruteForce) {
    for (const TestGeometry& scene : edgeCaseScenes()) {
        Random random(21);
        std::vector<Accel> accels;
        for (const TraversalCase& traversalCase : traversalCases())
            accels.push_back(build(scene, {}, traversalCase));
        for (const Ray& ray : edgeCaseRays(scene, 150, 44)) {
            Hit first;
            const double reach = accels[0].closestHit(ray, first) ? static_cast<double>(first.t) : 1.0;
            const double spreads[] = {0.0, 1e-7, 1e-4, 0.01, 0.1};
            const std::vector<Ray> rays = coherentRays(ray, reach, spreads[random.integer(5)], 50, random);
            std::vector<Hit> expected(rays.size()), hits(rays.size());
            std::vector<std::uint8_t> occluded(rays.size(), 7);
            for (std::size_t i = 0; i < rays.size(); ++i)
                bvh::closestHitBruteForce(scene.input(), rays[i], expected[i]);
            for (std::size_t traversalCase = 0; traversalCase < accels.size(); ++traversalCase) {
                accels[traversalCase].closestHits(rays, hits);
                accels[traversalCase].anyHits(rays, occluded);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    ASSERT_TRUE(sameHit(hits[i], expected[i]))
                        << scene.name << ", " << traversalCases()[traversalCase].name << ": " << text(rays[i])
                        << "\nfound " << text(hits[i]) << "\nbrute " << text(expected[i]);
                    ASSERT_EQ(occluded[i] != 0, expected[i].primitive != kNoPrimitive)
                        << scene.name << ", " << traversalCases()[traversalCase].name << ": "
                        << text(rays[i]);
                }
            }
        }
    }
}

}  // namespace
}  // namespace rayscope::test
