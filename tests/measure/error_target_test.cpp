// Estimates and bounds of errors, on synthetic noise and on scenes with a reference.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/error_target.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "measure/target/sample_allocation.h"
#include "support/expect_input_error.h"
#include "support/image_distance.h"

namespace rayscope {
namespace {

using test::inputErrorOf;
using testing::HasSubstr;

RgbImage noisy(int size, double sigma, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.5, sigma);
    RgbImage image(size, size);
    for (Rgb& pixel : image.pixels) pixel = Rgb(noise(random), noise(random), noise(random));
    return image;
}

ErrorTargetRequest targetRequest(const std::string& name, int size, double error) {
    Diagnostics notes;
    ErrorTargetRequest request;
    request.render.scene = std::make_shared<const SceneDescription>(loadScene(name, notes));
    request.render.camera = request.render.scene->cameras.front();
    request.render.width = request.render.height = size;
    request.target.error = error;
    return request;
}

TEST(ErrorEstimate, MatchesTheNoiseOfTwoHalves) {
    const PixelBounds whole{0, 100, 0, 100};
    const ErrorEstimate estimate = estimateError(noisy(100, 0.1, 1), noisy(100, 0.1, 2), whole, {});
    // The mean of two halves with standard deviation 0.1 has 0.1 / √2; 30000 values estimate it to 0.4 %.
    EXPECT_NEAR(estimate.error, 0.1 / std::sqrt(2.0), 0.0012);
    EXPECT_GT(estimate.upper, estimate.error);
    EXPECT_LT(estimate.upper, 1.05 * estimate.error);
    EXPECT_TRUE(estimate.reliable);
    EXPECT_EQ(estimateError(noisy(100, 0.1, 1), noisy(100, 0.1, 1), whole, {}).error, 0.0);
}

TEST(ErrorEstimate, UpperBoundHasTheConfidenceLevel) {
    ErrorTarget target;
    target.confidence = 0.9;
    const RgbImage reference(24, 24, Rgb(0.5f));
    int covered = 0;
    constexpr int kTimes = 1000;
    for (int time = 0; time < kTimes; ++time) {
        const auto seed = static_cast<std::uint64_t>(2 * time);
        const RgbImage a = noisy(24, 0.1, seed), b = noisy(24, 0.1, seed + 1);
        RgbImage mean = a;
        for (std::size_t i = 0; i < mean.pixels.size(); ++i)
            mean.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
        covered += test::distanceOf(mean, reference) <= estimateError(a, b, {0, 24, 0, 24}, target).upper;
    }
    EXPECT_NEAR(static_cast<double>(covered) / kTimes, 0.9, 0.04);  // four standard errors
}

TEST(ErrorEstimate, IsUnreliableIfOnePixelDominates) {
    RgbImage a(32, 32, Rgb(0.5f));
    const RgbImage b = a;
    for (int i = 0; i < 32; ++i) a.at(i, 0) += Rgb(0.01f);
    EXPECT_TRUE(estimateError(a, b, {0, 32, 0, 32}, {}).reliable);
    a.at(7, 7) = Rgb(100.0f);
    EXPECT_FALSE(estimateError(a, b, {0, 32, 0, 32}, {}).reliable);
    a.at(7, 7) = Rgb(NAN);
    EXPECT_TRUE(estimateError(a, b, {0, 32, 0, 32}, {}).reliable) << "non-finite pixels are left out";
    EXPECT_EQ(estimateError(a, b, {0, 32, 8, 32}, {}).error, 0.0) << "outside the region";
}

TEST(ErrorEstimate, IsReliableIfOnlyTheDifferenceIsDominatedByOnePixel) {
    RgbImage a(32, 32, Rgb(0.5f));
    const RgbImage b = a;
    a.at(7, 7) = Rgb(0.6f);
    VarianceImage variance(32, 32, 1e-4);
    const PixelBounds whole{0, 32, 0, 32};
    EXPECT_TRUE(estimateError(a, b, whole, {}, &variance).reliable)
        << "such a difference is likely by chance";
    variance.at(7, 7) = 1.0;
    EXPECT_FALSE(estimateError(a, b, whole, {}, &variance).reliable) << "rare bright samples";
    EXPECT_TRUE(estimateError(a, b, {0, 32, 8, 32}, {}, &variance).reliable) << "outside the region";
}

/// Two halves of a picture with very different noise per pixel, and estimated variances of the samples.
struct UnevenHalves {
    RgbImage a{32, 32}, b{32, 32}, mean{32, 32};
    VarianceImage variance{32, 32};

    explicit UnevenHalves(std::uint64_t seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> noise;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const double sigma = std::exp2(-static_cast<double>(i) / 16.0);
            a.pixels[i] = Rgb(static_cast<float>(sigma * noise(random)));
            b.pixels[i] = Rgb(static_cast<float>(sigma * noise(random)));
            mean.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
            variance.pixels[i] = 7.0 * sigma * sigma * std::exp(0.2 * noise(random));
        }
    }
};

TEST(ErrorEstimate, SampleVariancesMakeTheUpperBoundMoreAccurate) {
    constexpr int kTimes = 600;
    const PixelBounds whole{0, 32, 0, 32};
    const RgbImage reference(32, 32);
    ErrorTarget target;
    target.confidence = 0.9;
    std::vector<double> without, with;
    int covered = 0;
    for (int time = 0; time < kTimes; ++time) {
        const UnevenHalves halves(static_cast<std::uint64_t>(time));
        const ErrorEstimate plain = estimateError(halves.a, halves.b, whole, target);
        const ErrorEstimate known = estimateError(halves.a, halves.b, whole, target, &halves.variance);
        EXPECT_EQ(plain.error, known.error);
        covered += test::distanceOf(halves.mean, reference) <= known.upper;
        without.push_back(plain.upper / plain.error);
        with.push_back(known.upper / known.error);
    }
    EXPECT_NEAR(static_cast<double>(covered) / kTimes, 0.9, 0.05);  // four standard errors
    const auto range = [](std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        return values[values.size() * 9 / 10] / values[values.size() / 10];
    };
    EXPECT_LT(range(with), 1.0 + 0.2 * (range(without) - 1.0));
}

TEST(ErrorEstimate, WorstTileHasAtLeastTheErrorOfTheWhole) {
    RgbImage a(64, 64, Rgb(0.5f)), b = a;
    for (int y = 0; y < 32; ++y)
        for (int x = 32; x < 64; ++x) a.at(x, y) += Rgb(x % 2 ? 0.1f : -0.1f);
    ErrorTarget worst;
    worst.worstTile = true;
    EXPECT_NEAR(estimateError(a, b, {0, 64, 0, 64}, worst).error, 0.05, 1e-6);
    EXPECT_NEAR(estimateError(a, b, {0, 64, 0, 64}, {}).error, 0.025, 1e-6);
    ErrorTarget relative;
    relative.metric = ErrorMetric::RelMse;
    EXPECT_NEAR(estimateError(a, b, {32, 64, 0, 32}, relative).error, 0.0025 / 0.265, 0.001);
}

TEST(SampleAllocation, FollowsTheNoiseAndKeepsAMinimum) {
    render::Film film(160, 32, {0, 160, 0, 32});
    render::Film::TileCopy copy;
    for (int tile = 0; tile < 5; ++tile) {
        film.read(tile, copy);
        for (render::PixelSums& pixel : copy.pixels) {
            // Four samples: one of them bright in the first tile, all equal elsewhere.
            pixel.radiance = RgbSum(1.0);
            pixel.squaredLuminance = tile == 0 ? 1.0 : 0.25;
        }
        copy.samples = 4;
        film.commit(tile, std::move(copy));
    }
    const std::vector<double> allocation = measure::allocateSamples(film, false, false);
    EXPECT_GT(allocation[0], allocation[1]);
    EXPECT_NEAR(allocation[1], 0.5 * allocation[0], 1e-12) << "the neighbour of the noisy tile";
    EXPECT_NEAR(allocation[2], allocation[4], 1e-12);
    EXPECT_GT(allocation[4], 0.0);
    EXPECT_NEAR(allocation[0] + allocation[1] + allocation[2] + allocation[3] + allocation[4], 5.0, 1e-12);
}

TEST(ErrorTarget, HoldsTheConfidenceLevelOnScenes) {
    for (const bool adaptive : {false, true}) {
        for (const auto& [scene, error] :
             {std::pair{"builtin:cornell", 0.01}, std::pair{"builtin:cornell-area", 0.004}}) {
            ErrorTargetRequest request = targetRequest(scene, 32, error / 8.0);
            request.render.seed = 1000;
            const RgbImage reference = renderToTarget(request).mean;
            request.target.error = error;
            request.adaptive = adaptive;
            int below = 0;
            constexpr int kSeeds = 16;
            for (int seed = 0; seed < kSeeds; ++seed) {
                request.render.seed = static_cast<std::uint64_t>(seed);
                const ErrorTargetResult result = renderToTarget(request);
                EXPECT_EQ(result.reason, StopReason::Reached);
                EXPECT_LE(result.estimate.upper, error);
                below += test::distanceOf(result.mean, reference) <= error;
            }
            // With 95 % each, fewer than 13 of 16 have a probability of 1 in 140.
            EXPECT_GE(below, 13) << scene;
        }
    }
}

TEST(ErrorTarget, AdaptiveSamplingIsUnbiased) {
    ErrorTargetRequest request = targetRequest("builtin:cornell-area", 32, 0.0008);
    request.render.seed = 5000;
    const RgbImage reference = renderToTarget(request).mean;
    request.adaptive = true;
    request.target.error = 0.006;
    const auto brightness = [](const RgbImage& image) {
        double sum = 0.0;
        for (const Rgb& c : image.pixels)
            sum += static_cast<double>(c.x) + static_cast<double>(c.y) + static_cast<double>(c.z);
        return sum / (3.0 * static_cast<double>(image.pixels.size()));
    };
    double sum = 0.0, squares = 0.0;
    constexpr int kSeeds = 24;
    for (int seed = 0; seed < kSeeds; ++seed) {
        request.render.seed = static_cast<std::uint64_t>(seed);
        const double value = brightness(renderToTarget(request).mean);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSeeds, deviation = std::sqrt((squares - sum * mean) / (kSeeds - 1.0));
    EXPECT_NEAR(mean, brightness(reference), 3.5 * deviation / std::sqrt(kSeeds));
    EXPECT_LT(deviation, 1e-3) << "too noisy to find a bias";
}

TEST(ErrorTarget, DependsOnlyOnTheRequest) {
    ErrorTargetRequest request = targetRequest("builtin:cornell-area", 40, 0.004);
    request.threads = 1;
    const ErrorTargetResult one = renderToTarget(request);
    request.threads = 3;
    const ErrorTargetResult three = renderToTarget(request);
    EXPECT_EQ(one.mean.pixels, three.mean.pixels);
    EXPECT_EQ(one.samples, three.samples);
    request.render.seed = 1;
    EXPECT_NE(renderToTarget(request).mean.pixels, one.mean.pixels);
}

TEST(ErrorTarget, ReportsTheStopReason) {
    ErrorTargetRequest request = targetRequest("builtin:cornell-area", 32, 0.01);
    EXPECT_THAT(renderToTarget(request).text, HasSubstr("target error reached at rmse"));
    request.target.error = 1e-9;
    request.maxSamples = 24;
    const ErrorTargetResult few = renderToTarget(request);
    EXPECT_EQ(few.reason, StopReason::SampleLimit);
    EXPECT_EQ(few.samples, 24);
    request.maxSamples = 1 << 20;
    request.timeLimit = 0.3;
    const ErrorTargetResult late = renderToTarget(request);
    EXPECT_EQ(late.reason, StopReason::TimeLimit);
    EXPECT_THAT(late.text, HasSubstr("time limit"));
    EXPECT_GT(late.samples, 0.0);
    std::stop_source stop;
    request.timeLimit = 0.0;
    request.stop = stop.get_token();
    request.progress = [&](const ErrorForecast& f) {
        if (f.samples >= 32) stop.request_stop();
    };
    EXPECT_EQ(renderToTarget(request).reason, StopReason::Interrupted);
}

TEST(ErrorTarget, AStopWhileTheSceneIsCompiledGivesABlackImage) {
    ErrorTargetRequest request = targetRequest("builtin:cornell", 32, 0.01);
    std::stop_source stop;
    stop.request_stop();
    request.stop = stop.get_token();
    const ErrorTargetResult result = renderToTarget(request);
    EXPECT_EQ(result.reason, StopReason::Interrupted);
    EXPECT_THAT(result.text, HasSubstr("interrupted before its error could be estimated"));
    EXPECT_EQ(result.world, nullptr);
    EXPECT_EQ(result.mean.pixels, RgbImage(32, 32, Rgb(0.0f)).pixels);
}

TEST(ErrorTarget, ForecastsRemainingTimeAndErrorAtTheTimeLimit) {
    ErrorTargetRequest request = targetRequest("builtin:cornell-area", 48, 0.0008);
    request.timeLimit = 1000.0;
    const ErrorTargetResult result = renderToTarget(request);
    ASSERT_GE(result.history.size(), 4u);
    EXPECT_EQ(result.history.back().remainingSeconds, 0.0);
    EXPECT_GT(result.history[1].remainingSeconds, 0.0);
    EXPECT_LT(result.history[1].errorAtLimit, result.history[1].estimate.error);
}

/// Relative error of the last forecast before half of the samples; 0 if there was none.
double forecastError(const ErrorTargetResult& result) {
    double expected = result.samples;
    for (const ErrorForecast& f : result.history)
        if (2 * f.samples <= result.samples) expected = f.samplesAtTarget;
    return expected / result.samples - 1.0;
}

TEST(ErrorTarget, ForecastsAtHalfOfTheSamplesAreWithin25Percent) {
    for (const auto& [scene, error] :
         {std::pair{"builtin:cornell", 0.003}, std::pair{"builtin:cornell-area", 0.0009},
          std::pair{"builtin:teapot", 0.002}}) {
        ErrorTargetRequest request = targetRequest(scene, 32, error);
        int right = 0;
        constexpr int kSeeds = 16;
        for (int seed = 0; seed < kSeeds; ++seed) {
            request.render.seed = static_cast<std::uint64_t>(seed);
            right += std::abs(forecastError(renderToTarget(request))) <= 0.25;
        }
        // With 90 % each, fewer than 12 of 16 have a probability of 1 in 150.
        EXPECT_GE(right, 12) << scene;
    }
}

TEST(ErrorTarget, RejectsUnsupportedRequests) {
    ErrorTargetRequest request = targetRequest("builtin:cornell", 8, 0.01);
    EXPECT_THAT(inputErrorOf([&] { renderToTarget(request); }), HasSubstr("at least 256 pixels, not 64"));
    request = targetRequest("builtin:cornell", 32, 0.01);
    request.target.metric = ErrorMetric::Flip;
    EXPECT_THAT(inputErrorOf([&] { renderToTarget(request); }), HasSubstr("supports only rmse and relmse"));
    request.target.metric = ErrorMetric::Rmse;
    request.render.settings.sampler = SamplePattern::Jittered;
    EXPECT_THAT(inputErrorOf([&] { renderToTarget(request); }), HasSubstr("sampler=sobol"));
}

}  // namespace
}  // namespace rayscope
