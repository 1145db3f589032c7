#include "measure/bench/picture_rays.h"

#include <gtest/gtest.h>

#include <rayscope/diagnostics.h>
#include <string>
#include <vector>

#include "support/tracing.h"
#include "trace/compile.h"
#include "trace/radiance.h"

namespace rayscope {
namespace {

struct Case {
    const char* name;
    const char* scene;
    void (*change)(Settings&);
};

const Case kCases[] = {
    {"Plain", "builtin:cornell", [](Settings&) {}},
    {"ManyLightSamples", "builtin:cornell-area", [](Settings& s) { s.parallelogramSamples = 3; }},
    {"LightsWithoutShadows", "builtin:cornell-area", [](Settings& s) { s.softShadows = false; }},
    {"GlossBelowTheSurface", "builtin:cornell-glossy",
     [](Settings& s) { s.glossy = true, s.glossySigma = 5.0f, s.glossySamples = 9; }},
    {"AttenuatedShadows", "builtin:cornell-transparent", [](Settings& s) { s.transparentShadows = true; }},
    {"Layers", "builtin:cubes-transparent", [](Settings&) {}},
    {"Lens", "builtin:spheres-dof", [](Settings& s) { s.lensSamples = 5; }},
    {"SharpZone", "builtin:spheres-dof", [](Settings& s) { s.lensSamples = 2, s.sharpZone = 0.5f; }},
};

class PictureRaysOf : public testing::TestWithParam<Case> {
  protected:
    static std::shared_ptr<const trace::World> worldOf(const Case& tested, bool moving) {
        Diagnostics notes;
        SceneDescription scene = loadScene(tested.scene, notes);
        if (moving)
            for (MeshInstance& mesh : scene.meshes) mesh.motion = glm::vec3(0.1f, 0.0f, 0.05f);
        Settings settings;
        settings.spp = 2;
        tested.change(settings);
        return test::compileScene(std::move(scene), settings, 20, 20);
    }
};

/// The oracles are the tracer's own count of rays and the visibility of its light samples.
TEST_P(PictureRaysOf, AreThoseOfTheTracer) {
    for (const bool moving : {false, true}) {
        const auto world = worldOf(GetParam(), moving);
        std::vector<SampleId> samples;
        for (int i = 0; i < 20 * 20; ++i) samples.push_back({i % 20, i / 20, i % 2});
        std::uint64_t traced = 0, hits = 0;
        std::vector<bool> occluded;
        for (const SampleId& sample : samples) {
            test::RecordingObserver seen;
            traced += trace::radiance(*world, 7, sample, seen).rays;
            hits += seen.hits.size();
            for (const trace::LightConnection& light : seen.lights)
                if (light.visibility != Visibility::FacingAway &&
                    world->lights[static_cast<std::size_t>(light.light)].castsShadows)
                    occluded.push_back(light.visibility == Visibility::Occluded);
        }
        const measure::PictureRays rays = measure::recordRays(*world, 7, samples);
        EXPECT_EQ(rays.size(), traced);
        const auto timeOf = [&](const measure::TimedRays& list, std::size_t i) {
            return world->moves ? list.times.at(i) : 0.0f;
        };
        std::uint64_t found = 0;
        Hit hit;
        for (std::size_t i = 0; i < rays.closest.rays.size(); ++i)
            found += world->closestHit(rays.closest.rays[i], timeOf(rays.closest, i), hit);
        if (world->attenuatesShadows || world->settings.sharpZone > 0.0f)
            EXPECT_GE(found, hits);  // some rays are of no segment
        else
            EXPECT_EQ(found, hits);
        if (world->attenuatesShadows) {
            EXPECT_TRUE(rays.any.rays.empty());
            continue;
        }
        ASSERT_EQ(rays.any.rays.size(), occluded.size());
        for (std::size_t i = 0; i < occluded.size(); ++i)
            EXPECT_EQ(world->anyHit(rays.any.rays[i], timeOf(rays.any, i)), occluded[i]) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, PictureRaysOf, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace rayscope
