#include "render/film.h"

#include <gtest/gtest.h>

#include "render/pass_plan.h"

namespace rayscope {
namespace {

TEST(Film, TilesCoverTheRegionOnce) {
    const PixelBounds region{5, 105, 7, 64};
    const render::Film film(200, 100, region);
    Image<int> count(200, 100, 0);
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        const PixelBounds b = film.tileBounds(tile);
        for (int y = b.y0; y < b.y1; ++y)
            for (int x = b.x0; x < b.x1; ++x) ++count.at(x, y);
    }
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x)
            EXPECT_EQ(count.at(x, y), x >= 5 && x < 105 && y >= 7 && y < 64 ? 1 : 0);
}

TEST(Film, ReturnsTheCommittedTile) {
    render::Film film(40, 40, {0, 40, 0, 40});
    render::Film::TileCopy copy;
    film.read(1, copy);
    EXPECT_EQ(copy.pixels.size(), 8u * 32u);
    copy.pixels[8 * 3 + 2].radiance = RgbSum(6.0, 3.0, 1.5);
    copy.samples = 3;
    film.commit(1, std::move(copy));
    int samples = 0;
    EXPECT_EQ(film.sums(34, 3, samples).radiance, RgbSum(6.0, 3.0, 1.5));
    EXPECT_EQ(samples, 3);
    EXPECT_EQ(film.mean().at(34, 3), Rgb(2.0f, 1.0f, 0.5f));
    EXPECT_EQ(film.completeSamples(), 0);
    EXPECT_EQ(film.version(1), 1u);
    EXPECT_EQ(film.version(0), 0u);
}

TEST(PassPlan, EndsAtTheTarget) {
    for (const bool progressive : {true, false})
        for (const int target : {1, 2, 3, 16, 17, 1000}) {
            int samples = 0, passes = 0;
            for (; samples < target; ++passes) {
                const int next = render::nextPassTarget(samples, target, progressive);
                ASSERT_GT(next, samples);
                samples = next;
            }
            EXPECT_EQ(samples, target);
            EXPECT_LE(passes, target);
        }
    EXPECT_EQ(render::nextPassTarget(0, 64, true), 1);
    EXPECT_EQ(render::nextPassTarget(1, 64, true), 2);
    EXPECT_EQ(render::nextPassTarget(8, 64, true), 16);
}

}  // namespace
}  // namespace rayscope
