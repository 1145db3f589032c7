// Rounding of sums over very many samples.
#include <gtest/gtest.h>

#include <cmath>

#include "render/film.h"
#include "sampling/hash.h"

namespace rayscope {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t kSamples = 100'000'000;
#else  // with sanitizers
constexpr std::uint64_t kSamples = 10'000'000;
#endif

TEST(Accumulation, OfAHundredMillionSamplesIsExactToFloatPrecision) {
    render::Film film(1, 1, {0, 1, 0, 1});
    render::Film::TileCopy copy;
    film.read(0, copy);
    std::uint64_t exact = 0;  // in units of 2^-24, so without rounding
    RgbSum sum(0.0);
    for (std::uint64_t i = 0; i < kSamples; ++i) {
        const std::uint64_t units = sampling::mix(i) >> 40;
        exact += units;
        const float sample = static_cast<float>(units) * 0x1p-24f;
        sum += RgbSum(static_cast<double>(sample), 0.1, 1e9);
    }
    copy.pixels[0].radiance = sum;
    copy.samples = static_cast<int>(kSamples);
    film.commit(0, std::move(copy));

    const Rgb mean = film.mean().at(0, 0);
    const double n = static_cast<double>(kSamples), expected = static_cast<double>(exact) * 0x1p-24 / n;
    const auto ulp = [](float x) { return static_cast<double>(std::nextafter(x, 2.0f * x) - x); };
    EXPECT_NEAR(static_cast<double>(mean.x), expected, ulp(mean.x));
    EXPECT_NEAR(static_cast<double>(mean.y), 0.1, ulp(0.1f));
    EXPECT_EQ(mean.z, 1e9f);
    // Uniform numbers have a standard deviation of sqrt(1/12).
    EXPECT_NEAR(static_cast<double>(mean.x), 0.5, 4.0 * std::sqrt(1.0 / 12.0 / n) + ulp(0.5f));
}

}  // namespace
}  // namespace rayscope
