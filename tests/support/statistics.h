#pragma once
// Comparison of Monte Carlo estimates with exact results. Every seed of a pixel is an independent scrambling,
// so the spread between seeds gives an unbiased standard error for every sampler.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace rayscope::test {

/// The mean over independent runs and its standard error.
struct Estimate {
    double mean = 0.0, standardError = 0.0;
};

/// `run(seed)` gives one estimate.
template <class Run>
Estimate estimateOver(int runs, Run&& run) {
    double mean = 0.0, squares = 0.0;
    for (int i = 0; i < runs; ++i) {
        const double value = run(static_cast<std::uint64_t>(i));
        const double delta = value - mean;
        mean += delta / (i + 1);
        squares += delta * (value - mean);
    }
    return {mean, std::sqrt(squares / (runs - 1.0) / runs)};
}

/// Keeps the larger of the two; a deviation that is not finite fails the test.
inline void updateWorst(double& worst, double deviation) {
    EXPECT_TRUE(std::isfinite(deviation));
    if (deviation > worst) worst = deviation;
}

/// Prints the deviation of the tracer from an independent result, as docs/effects.md states it.
inline void reportDeviation(const std::string& what, double deviation, const std::string& unit = "") {
    fmt::print("deviation: {}: {:.2e}{}{}\n", what, deviation, unit.empty() ? "" : " ", unit);
    testing::Test::RecordProperty("deviation: " + what, fmt::format("{:.3e}", deviation));
}

/// Scene data, ray origins and directions are floats: some 16 roundings of 2^-24 each between a scene and its
/// radiance, so even an estimate without spread agrees with an exact result no better than this.
inline constexpr double kFloatRounding = 0x1p-20;

/// Passes if the mean is within 4 standard errors of the exact result, and if the same test would have
/// detected an error of one per cent.
inline void expectUnbiased(const std::string& what, const Estimate& estimate, double exact) {
    const double tolerance = 4.0 * estimate.standardError + kFloatRounding * std::abs(exact);
    EXPECT_NEAR(estimate.mean, exact, tolerance) << what;
    EXPECT_GT(std::abs(1.01 * estimate.mean - exact), tolerance) << what << ": too noisy to find a 1 % error";
    reportDeviation(
        what + fmt::format(" ({:+.1f} standard errors)", (estimate.mean - exact) / tolerance * 4.0),
        std::abs(estimate.mean / exact - 1.0), "relative");
}

/// Slope of log(RMSE) over log(n) for n = 16, 64, 256, 1024, by least squares. `error(run, n)` is the error
/// of one estimate from n samples; runs should differ in seed and in where an edge cuts the strata.
template <class Error>
double convergenceSlope(int runs, Error&& error) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    constexpr int kPoints = 4;
    for (int k = 0, n = 16; k < kPoints; ++k, n *= 4) {
        double squares = 0.0;
        for (int i = 0; i < runs; ++i) squares += std::pow(error(i, n), 2.0);
        const double logN = std::log(n), logError = 0.5 * std::log(squares / runs);
        x += logN, y += logError, xx += logN * logN, xy += logN * logError;
    }
    return (kPoints * xy - x * y) / (kPoints * xx - x * x);
}

/// Passes if the error falls at least as fast as in theory. With 100 runs per point the slope over two
/// decades has a standard error of 0.025; the margin is four of them.
inline void expectSlope(const std::string& what, double slope, double theory) {
    EXPECT_LT(slope, theory + 0.1) << what;
    fmt::print("slope: {}: {:.2f} (theory {:.2f})\n", what, slope, theory);
    testing::Test::RecordProperty("slope: " + what, fmt::format("{:.3f}", slope));
}

}  // namespace rayscope::test
