// Warnings about images that do not fit the sphere or the cube around the scene.
#include <fmt/format.h>

#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class EnvironmentShape : public SceneFiles {
  protected:
    /// Writes an image with the value f(column, row).
    template <class F>
    void image(const std::string& name, int width, int height, F&& f) {
        RgbImage picture(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) picture.at(x, y) = Rgb(static_cast<float>(f(x, y)));
        writeImage((folder_ / name).string(), picture);
    }
    void grey(const std::string& name, int width, int height) {
        image(name, width, height, [](int, int) { return 0.5; });
    }
    std::string notesOf(const std::string& environment) {
        notes_.clear();
        load(write("scene.toml", "version = 1\n[environment]\n" + environment));
        std::string text;
        for (const Diagnostic& note : notes_)
            if (note.position.line == 2) text += toString(note) + "\n";
        return text;
    }
};

const char* const kCube =
    "cube = { px = \"px.pfm\", nx = \"nx.pfm\", py = \"py.pfm\", ny = \"ny.pfm\", pz = \"pz.pfm\", nz = "
    "\"nz.pfm\" }\n";
constexpr const char* kFaces[] = {"px", "nx", "py", "ny", "pz", "nz"};

TEST_F(EnvironmentShape, LatitudeLongitudeImagesAreTwiceAsWideAsHigh) {
    for (const auto& [width, height] : {std::pair{8, 4}, std::pair{2, 1}}) {
        grey("e.pfm", width, height);
        EXPECT_EQ(notesOf("equirect = \"e.pfm\"\n"), "");
    }
    for (const auto& [width, height] : {std::pair{4, 4}, std::pair{1, 1}, std::pair{4, 8}, std::pair{9, 4}}) {
        grey("e.pfm", width, height);
        EXPECT_THAT(notesOf("equirect = \"e.pfm\"\n"), AllOf(HasSubstr("scene.toml:2:1: warning: "),
                                                             HasSubstr(fmt::format("{} x {}", width, height)),
                                                             HasSubstr("twice as wide as high")));
    }
}

TEST_F(EnvironmentShape, ImagesOfACubeAreSquareAndOfOneSize) {
    for (const char* face : kFaces) grey(std::string(face) + ".pfm", 4, 4);
    EXPECT_EQ(notesOf(kCube), "");
    grey("ny.pfm", 8, 8);
    EXPECT_THAT(notesOf(kCube),
                AllOf(HasSubstr("differ in size"), HasSubstr("ny 8 x 8"), Not(HasSubstr("square"))));
    grey("ny.pfm", 4, 2);
    grey("pz.pfm", 1, 4);
    EXPECT_THAT(notesOf(kCube), AllOf(HasSubstr("should be square; stretched: ny 4 x 2, pz 1 x 4 pixels")));
}

/// Images of a panorama whose value is the angle around y, from the side images' point of view: each image
/// covers a quarter turn to the right, starting at the given quarter.
TEST_F(EnvironmentShape, LeftHandedCubesAreRecognised) {
    const auto panorama = [&](std::array<int, 4> quarterOfPxNxPzNz) {
        constexpr const char* kSides[] = {"px.pfm", "nx.pfm", "pz.pfm", "nz.pfm"};
        for (std::size_t i = 0; i < 4; ++i)
            image(kSides[i], 16, 16, [&](int x, int y) {
                const double turn = (quarterOfPxNxPzNz[i] + (x + 0.5) / 16.0) / 4.0;
                return 0.5 + 0.4 * std::sin(6.283185307 * turn + 0.05 * y);
            });
        for (const char* face : {"py.pfm", "ny.pfm"}) grey(face, 16, 16);
    };
    // To the right of +z is −x, then −z, then +x.
    panorama({3, 1, 0, 2});
    EXPECT_EQ(notesOf(kCube), "");
    // In a left-handed world it is +x, then −z, then −x.
    panorama({1, 3, 0, 2});
    EXPECT_THAT(notesOf(kCube), HasSubstr("with px and nx exchanged"));
    // Unrelated images fit in no order.
    for (std::size_t i = 0; i < 6; ++i)
        image(std::string(kFaces[i]) + ".pfm", 16, 16, [&](int x, int y) {
            return static_cast<double>((x * 7 + y * 13 + static_cast<int>(i) * 29) % 31) / 31.0;
        });
    EXPECT_EQ(notesOf(kCube), "");
}

}  // namespace
}  // namespace rayscope::test
