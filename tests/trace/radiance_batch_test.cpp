#include "trace/radiance_batch.h"

#include <gtest/gtest.h>

#include <rayscope/diagnostics.h>
#include <bit>
#include <string>
#include <vector>

#include "support/tracing.h"
#include "trace/compile.h"
#include "trace/radiance_definition.h"

namespace rayscope::test {
namespace {

struct Case {
    const char* name;
    const char* scene;
    void (*change)(Settings&);
};

/// Settings that change which rays of a sample depend on others.
const Case kCases[] = {
    {"Plain", "builtin:cornell", [](Settings&) {}},
    {"NoTree", "builtin:cornell", [](Settings& s) { s.bvh = false; }},
    {"BinaryTree", "builtin:cornell", [](Settings& s) { s.bvhLayout = BvhLayout::Binary; }},
    {"MoreTermsThanTheQueueHolds", "builtin:cornell-area", [](Settings& s) { s.parallelogramSamples = 40; }},
    {"OneTermPerLight", "builtin:cornell-area", [](Settings& s) { s.parallelogramSamples = 1; }},
    {"Gloss", "builtin:cornell-glossy", [](Settings& s) { s.glossy = true, s.glossySamples = 70; }},
    {"GlossBelowTheSurface", "builtin:cornell-glossy",
     [](Settings& s) { s.glossy = true, s.glossySigma = 5.0f, s.glossySamples = 9; }},
    {"AttenuatedShadows", "builtin:cornell-transparent", [](Settings& s) { s.transparentShadows = true; }},
    {"Layers", "builtin:cubes-transparent", [](Settings&) {}},
    {"LensWithOneRay", "builtin:spheres-dof", [](Settings& s) { s.lensSamples = 1; }},
    {"LensWithManyRays", "builtin:spheres-dof", [](Settings& s) { s.lensSamples = 65; }},
    {"SharpZone", "builtin:spheres-dof", [](Settings& s) { s.lensSamples = 2, s.sharpZone = 0.5f; }},
    {"Environment", "builtin:environment", [](Settings& s) { s.reflectionMap = true; }},
    {"WithoutShading", "builtin:cornell", [](Settings& s) { s.shading = false; }},
};

std::shared_ptr<const trace::World> worldOf(const Case& tested, bool moving) {
    Diagnostics notes;
    SceneDescription scene = loadScene(tested.scene, notes);
    if (moving)
        for (MeshInstance& mesh : scene.meshes) mesh.motion = glm::vec3(0.1f, 0.0f, 0.05f);
    trace::CompileRequest request;
    request.camera = scene.cameras.front();
    request.scene = std::make_shared<const SceneDescription>(std::move(scene));
    request.settings.spp = 2;
    tested.change(request.settings);
    request.width = request.height = 12;
    return trace::compile(request);
}

std::array<std::uint64_t, 3> bitsOf(const RgbSum& c) {
    return {std::bit_cast<std::uint64_t>(c.x), std::bit_cast<std::uint64_t>(c.y),
            std::bit_cast<std::uint64_t>(c.z)};
}

class RadianceBatchOf : public testing::TestWithParam<Case> {};

TEST_P(RadianceBatchOf, EqualsRadianceOfEachSample) {
    for (const bool moving : {false, true}) {
        const auto world = worldOf(GetParam(), moving);
        std::vector<SampleId> samples;
        for (int y = 0; y < world->height; ++y)
            for (int x = 0; x < world->width; ++x)
                for (int index = 0; index < 2; ++index) samples.push_back({x, y, index});
        const std::stop_token stop;
        trace::RadianceBatch batch(*world, 7, stop);
        double sum = 0.0;
        // Batches of different sizes with the same object.
        for (std::size_t begin = 0, size = 1; begin < samples.size();
             begin += size, size = size * 3 % 200 + 1) {
            const auto some = std::span(samples).subspan(begin, std::min(size, samples.size() - begin));
            batch.start(some);
            while (batch.next()) batch.trace();
            const auto results = batch.finish();
            ASSERT_EQ(results.size(), some.size());
            for (std::size_t i = 0; i < some.size(); ++i) {
                trace::NullObserver observer;
                const trace::SampleResult alone = trace::radiance(*world, 7, some[i], observer);
                ASSERT_EQ(bitsOf(results[i].radiance), bitsOf(alone.radiance))
                    << some[i].x << ' ' << some[i].y;
                ASSERT_EQ(results[i].rays, alone.rays);
                sum += alone.radiance.y;
            }
        }
        EXPECT_GT(sum, 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, RadianceBatchOf, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(RadianceBatch, OfNoSamplesIsEmpty) {
    const auto world = worldOf(kCases[0], false);
    const std::stop_token stop;
    trace::RadianceBatch batch(*world, 0, stop);
    batch.start({});
    EXPECT_FALSE(batch.next());
    EXPECT_TRUE(batch.finish().empty());
}

template <class Observer, class Terms>
concept CanTrace = requires {
    typename trace::Tracer<Observer, Terms>;
};

// A queue that defers shadow rays would hide light samples from an observer: that must not compile.
static_assert(CanTrace<trace::NullObserver, trace::TermQueue>);
static_assert(CanTrace<trace::NullObserver, trace::TermSum>);
static_assert(CanTrace<EventCounter, trace::TermSum>);
static_assert(!CanTrace<EventCounter, trace::TermQueue>);
static_assert(!CanTrace<RecordingObserver, trace::TermQueue>);

}  // namespace
}  // namespace rayscope::test
