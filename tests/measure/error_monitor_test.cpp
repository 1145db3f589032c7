#include "measure/target/error_monitor.h"

#include <gtest/gtest.h>

#include <rayscope/scene.h>
#include <cmath>

#include "render/render_pass.h"
#include "support/image_distance.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

std::shared_ptr<const trace::World> worldOf(const std::string& name, SamplePattern sampler) {
    Diagnostics notes;
    Settings settings;
    settings.sampler = sampler;
    settings.parallelogramSamples = 1;
    return test::compileScene(loadScene("builtin:" + name, notes), settings, 48, 48);
}

void extend(const trace::World& world, render::Film& film, int samples, std::uint64_t seed) {
    render::RenderCounters counters;
    render::renderPass(world, seed, film, samples, {}, counters);
}

/// Against the distance to a picture with far more samples.
TEST(ErrorMonitor, EstimatesErrorAndUpperBound) {
    for (const SamplePattern sampler : {SamplePattern::Independent, SamplePattern::Sobol}) {
        const auto world = worldOf("cornell-area", sampler);
        render::Film reference(48, 48, {0, 48, 0, 48});
        extend(*world, reference, 768, 999);
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            render::Film film(48, 48, {0, 48, 0, 48});
            measure::ErrorMonitor monitor(ErrorTarget{.error = 1e-9}, sampler);
            EXPECT_FALSE(monitor.hasEstimate());
            for (int samples = 1; samples <= 32; samples *= 2) {
                extend(*world, film, samples, seed);
                EXPECT_TRUE(monitor.isEstimateDue(film.completeSamples()));
                monitor.update(measure::ErrorMonitor::snapshotOf(film));
                EXPECT_FALSE(monitor.isEstimateDue(film.completeSamples()));
            }
            const double error = test::distanceOf(film.mean(), reference.mean());
            ASSERT_TRUE(monitor.hasEstimate());
            EXPECT_LE(error, 1.1 * monitor.latest().upper);
            // Sobol points of the second half fill the gaps of the first: the estimate is conservative.
            EXPECT_GE(error, (sampler == SamplePattern::Sobol ? 0.3 : 0.85) * monitor.latest().error);
            EXPECT_FALSE(monitor.reached());
        }
    }
}

TEST(ErrorMonitor, ForecastsTimeToTheTargetAndErrorAtTheTimeLimit) {
    const auto world = worldOf("cornell-area", SamplePattern::Independent);
    render::Film film(48, 48, {0, 48, 0, 48});
    measure::ErrorMonitor first(ErrorTarget{.error = 1e-9}, SamplePattern::Independent);
    for (int samples = 1; samples <= 16; samples *= 2) {
        extend(*world, film, samples, 5);
        first.update(measure::ErrorMonitor::snapshotOf(film));
    }
    // Half the error of independent samples takes four times the samples.
    measure::ErrorMonitor monitor(ErrorTarget{.error = 0.55 * first.latest().upper},
                                  SamplePattern::Independent);
    render::Film again(48, 48, {0, 48, 0, 48});
    for (int samples = 1; samples <= 16; samples *= 2) {
        extend(*world, again, samples, 5);
        monitor.update(measure::ErrorMonitor::snapshotOf(again));
    }
    const ErrorForecast f = monitor.forecast(16.0, 8.0, 32.0);
    EXPECT_FALSE(monitor.reached());
    EXPECT_NEAR(f.remainingSeconds, 24.0, 8.1) << "32 or 64 samples, at half a second each";
    EXPECT_NEAR(f.errorAtLimit, 0.5 * monitor.latest().error, 0.15 * monitor.latest().error);
    extend(*world, again, 128, 5);
    monitor.update(measure::ErrorMonitor::snapshotOf(again));
    EXPECT_TRUE(monitor.reached());
    EXPECT_EQ(monitor.forecast(128.0, 64.0, 0.0).remainingSeconds, 0.0);
}

TEST(ErrorMonitor, HandlesEmptyFilmsAndUnevenTiles) {
    const auto world = worldOf("cornell-area", SamplePattern::Sobol);
    render::Film film(48, 48, {0, 48, 0, 48});
    measure::ErrorMonitor monitor;
    monitor.update(measure::ErrorMonitor::snapshotOf(film));
    EXPECT_FALSE(monitor.hasEstimate());
    EXPECT_EQ(monitor.forecast(0.0, 0.0, 1.0).errorAtLimit, 0.0);
    extend(*world, film, 4, 1);
    monitor.update(measure::ErrorMonitor::snapshotOf(film));
    std::vector<int> targets(static_cast<std::size_t>(film.tileCount()), 8);
    targets[0] = 20;
    render::RenderCounters counters;
    render::renderPass(*world, 1, film, targets, {}, counters);
    monitor.update(measure::ErrorMonitor::snapshotOf(film));
    ASSERT_TRUE(monitor.hasEstimate());
    EXPECT_TRUE(std::isfinite(monitor.latest().error));
    EXPECT_GT(monitor.latest().error, 0.0);
}

}  // namespace
}  // namespace rayscope
