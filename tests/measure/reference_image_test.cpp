#include "measure/trade/reference_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/image_distance.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

trace::CompileRequest requestFor(const std::string& name, int size) {
    Diagnostics notes;
    auto scene = std::make_shared<const SceneDescription>(loadScene(name, notes));
    return {scene, measure::referenceSettings(Settings{}), scene->cameras.front(), size, size};
}

RgbImage noisy(const RgbImage& exact, double sigma, double bias, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(bias, sigma);
    RgbImage image = exact;
    for (Rgb& pixel : image.pixels) pixel += Rgb(noise(random), noise(random), noise(random));
    return image;
}

TEST(ReferenceImage, ErrorEstimatesAreFreeOfItsNoise) {
    const RgbImage exact(200, 200, Rgb(0.5f));
    // The halves are twice as noisy as the images: plain squared differences would be five times too large.
    const RgbImage a = noisy(exact, 0.2, 0.0, 1), b = noisy(exact, 0.2, 0.0, 2);
    const RgbImage one = noisy(exact, 0.1, 0.05, 3), other = noisy(exact, 0.1, 0.05, 4);
    // Standard error over 120000 values: at most 4 products of 0.2 · 0.2 / √120000.
    EXPECT_NEAR(measure::meanSquaredError(one, a, b), 0.01 + 0.0025, 4e-4);
    EXPECT_NEAR(measure::meanErrorProduct(one, other, a, b), 0.0025, 4e-4);
}

TEST(ReferenceImage, NonFinitePixelsAreLeftOut) {
    const RgbImage exact(10, 10, Rgb(0.5f)), image(10, 10, Rgb(0.75f));
    RgbImage broken = image;
    broken.at(3, 3) = Rgb(NAN);
    broken.at(4, 3) = Rgb(INFINITY);
    EXPECT_DOUBLE_EQ(measure::meanSquaredError(broken, exact, exact), 0.0625);
    EXPECT_TRUE(
        std::isnan(measure::meanSquaredError(RgbImage(2, 2, Rgb(NAN)), RgbImage(2, 2), RgbImage(2, 2))));
}

// A few hundred pixels at edges have most of the error, so its estimate has a standard error of about 5 %.
TEST(ReferenceImage, EstimatesItsOwnError) {
    render::ThreadArena workers(2);
    measure::ReferenceImage reference(requestFor("builtin:cornell-area", 80), workers);
    ASSERT_TRUE(reference.extend(8, {}));
    const RgbImage early = reference.mean();
    const double estimated = reference.error();
    ASSERT_TRUE(reference.extend(256, {}));
    EXPECT_LT(reference.error(), 0.2 * estimated);
    EXPECT_NEAR(test::distanceOf(early, reference.mean()) / estimated, 1.0, 0.15);
}

TEST(ReferenceImage, ConvergesIfItsErrorFalls) {
    EXPECT_TRUE(measure::converges({}));
    EXPECT_TRUE(measure::converges({{4, 0.1}, {8, 0.2}})) << "too few steps";
    EXPECT_TRUE(measure::converges({{4, 0.1}, {8, 0.07}, {16, 0.05}}));
    EXPECT_FALSE(measure::converges({{4, 0.1}, {8, 0.11}, {16, 0.09}})) << "rare bright samples";
    EXPECT_FALSE(measure::converges({{4, 0.1}, {8, 0.07}, {16, NAN}}));
    EXPECT_TRUE(measure::converges({{2, 0.1}, {4, 0.1}, {8, 0.08}, {16, 0.06}}));
}

TEST(ReferenceImage, ContinuesFromAFileBitForBit) {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("sub/r.films");
    render::ThreadArena workers(2);
    measure::ReferenceImage whole(requestFor("builtin:cornell", 40), workers),
        part(requestFor("builtin:cornell", 40), workers);
    whole.extend(8, {});
    part.extend(4, {});
    part.save(file);
    measure::ReferenceImage resumed(requestFor("builtin:cornell", 40), workers);
    ASSERT_TRUE(resumed.load(file));
    EXPECT_EQ(resumed.samples(), 4);
    resumed.extend(8, {});
    EXPECT_EQ(resumed.mean().pixels, whole.mean().pixels);
}

TEST(ReferenceImage, RejectsDamagedAndForeignFiles) {
    const test::TemporaryFolder folder;
    render::ThreadArena workers(2);
    measure::ReferenceImage reference(requestFor("builtin:cornell", 40), workers);
    reference.extend(2, {});
    reference.save(folder.file("r.films"));
    const std::string good = test::readText(folder / "r.films");

    const auto loads = [&](const std::string& scene, int size, const std::string& content) {
        folder.write("t.films", content);
        measure::ReferenceImage fresh(requestFor(scene, size), workers);
        const bool loaded = fresh.load(folder.file("t.films"));
        EXPECT_EQ(fresh.samples(), loaded ? 2 : 0);
        return loaded;
    };
    EXPECT_TRUE(loads("builtin:cornell", 40, good));
    std::string flipped = good;
    flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 1);
    EXPECT_FALSE(loads("builtin:cornell", 40, flipped));
    EXPECT_FALSE(loads("builtin:cornell", 40, good.substr(0, good.size() - 1)));
    EXPECT_FALSE(loads("builtin:cornell", 40, ""));
    EXPECT_FALSE(loads("builtin:cornell", 41, good));
    EXPECT_FALSE(loads("builtin:cornell-area", 40, good));
    measure::ReferenceImage fresh(requestFor("builtin:cornell", 40), workers);
    EXPECT_FALSE(fresh.load(folder.file("missing.films")));
}

TEST(ReferenceImage, CanBeExtendedAfterAStop) {
    render::ThreadArena workers(2);
    measure::ReferenceImage reference(requestFor("builtin:cornell", 40), workers);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(reference.extend(64, stop.get_token()));
    EXPECT_EQ(reference.samples(), 0);
    EXPECT_TRUE(reference.extend(1, {}));
}

}  // namespace
}  // namespace rayscope
