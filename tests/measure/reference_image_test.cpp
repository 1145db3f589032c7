#include "measure/trade/reference_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "measure/trade/film_file.h"
#include "support/expect_input_error.h"
#include "support/image_distance.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using testing::HasSubstr;

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

    const auto problemOf = [&](const std::string& scene, int size, const std::string& content) {
        const std::string file = folder.write("t.films", content);
        measure::ReferenceImage fresh(requestFor(scene, size), workers);
        const std::string problem = test::inputErrorOf([&] { fresh.load(file); });
        EXPECT_EQ(fresh.samples(), 0);
        return problem;
    };
    measure::ReferenceImage same(requestFor("builtin:cornell", 40), workers);
    EXPECT_TRUE(same.load(folder.file("r.films")));
    EXPECT_EQ(same.samples(), 2);
    std::string flipped = good;
    flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 1);
    EXPECT_THAT(problemOf("builtin:cornell", 40, flipped), HasSubstr("is damaged"));
    EXPECT_THAT(problemOf("builtin:cornell", 40, good.substr(0, good.size() - 1)),
                HasSubstr("is incomplete"));
    EXPECT_THAT(problemOf("builtin:cornell", 40, good + "x"), HasSubstr("bytes, more than"));
    EXPECT_THAT(problemOf("builtin:cornell", 40, ""), HasSubstr("another scene or version"));
    EXPECT_THAT(problemOf("builtin:cornell", 41, good), HasSubstr("another scene or version"));
    EXPECT_THAT(problemOf("builtin:cornell-area", 40, good), HasSubstr("another scene or version"));
    measure::ReferenceImage fresh(requestFor("builtin:cornell", 40), workers);
    EXPECT_FALSE(fresh.load(folder.file("missing.films")));
}

/// Films of 40 x 40 pixels, all tiles with the same samples and sums.
std::pair<std::unique_ptr<render::Film>, std::unique_ptr<render::Film>> filmsWith(
    int samples, const render::PixelSums& sums) {
    const auto make = [&] {
        auto film = std::make_unique<render::Film>(40, 40, PixelBounds{0, 40, 0, 40});
        for (int tile = 0; tile < film->tileCount(); ++tile) {
            render::Film::TileCopy copy;
            film->read(tile, copy);
            for (render::PixelSums& pixel : copy.pixels) pixel = sums;
            copy.samples = samples;
            film->commit(tile, std::move(copy));
        }
        return film;
    };
    return {make(), make()};
}

TEST(ReferenceImage, RejectsWellFormedFilesThatNoRenderWrote) {
    const test::TemporaryFolder folder;
    render::ThreadArena workers(2);
    measure::ReferenceImage reference(requestFor("builtin:cornell", 40), workers);
    const std::string file = folder.file("t.films");
    const auto [a, b] = filmsWith(4, {RgbSum(2.0), 1.0});
    measure::saveFilms(file, reference.contentHash(), *a, *b);
    EXPECT_THAT(test::inputErrorOf([&] { reference.load(file); }), HasSubstr("rendered anew differ"));
    EXPECT_EQ(reference.samples(), 0);
}

TEST(FilmFile, RefusesWhatNoRenderCanHaveMade) {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("t.films");
    const auto [good, other] = filmsWith(4, {RgbSum(2.0), 1.0});
    measure::saveFilms(file, "hash", *good, *other);
    const std::string content = test::readText(file);
    const render::PixelSums possible{RgbSum(2.0), 1.0};
    const std::tuple<int, render::PixelSums, const char*> cases[] = {
        {-1, possible, "-1 samples"},
        {(1 << 20) + 1, possible, "1048577 samples"},
        {0, possible, "impossible"},
        {4, {RgbSum(NAN), 1.0}, "impossible"},
        {4, {RgbSum(2.0), INFINITY}, "impossible"},
        {4, {RgbSum(2.0), -1.0}, "impossible"},
        {4, {RgbSum(3.0), 1.0}, "impossible"},
    };
    for (const auto& [samples, sums, problem] : cases) {
        const auto [a, b] = filmsWith(samples, sums);
        EXPECT_THAT(test::inputErrorOf([&] { measure::saveFilms(file, "hash", *a, *b); }),
                    HasSubstr(problem));
        // The first tile of a well-formed file, with the checksum that belongs to it.
        std::string changed = content.substr(0, content.size() - sizeof(std::uint64_t));
        const std::size_t at = changed.find('\n') + 1;
        std::memcpy(changed.data() + at, &samples, sizeof samples);
        std::memcpy(changed.data() + at + sizeof samples, &sums, sizeof sums);
        const std::uint64_t sum = measure::filmFileChecksum(changed);
        changed.append(reinterpret_cast<const char*>(&sum), sizeof sum);
        folder.write("t.films", changed);
        render::Film c(40, 40, {0, 40, 0, 40}), d(40, 40, {0, 40, 0, 40});
        EXPECT_THAT(test::inputErrorOf([&] { measure::loadFilms(file, "hash", c, d); }), HasSubstr(problem));
        EXPECT_EQ(c.completeSamples(), 0);
    }
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
