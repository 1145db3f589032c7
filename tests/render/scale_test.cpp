// The whole path from file to picture, with its defaults, at every scale that float holds.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rayscope/open_request.h>
#include <rayscope/render_image.h>

#include <cmath>

#include "math/vectors.h"
#include "support/statistics.h"
#include "support/temporary_folder.h"

namespace rayscope::test {
namespace {

constexpr int kSize = 24;

/// A number of the scene at scale 10^k, with all digits of a double, so that it is rounded to float once.
std::string scaled(double x, int k) { return fmt::format("{:.17g}", x * std::pow(10.0, k)); }
std::string scaled(const glm::dvec3& v, int k, const char* separator) {
    return scaled(v.x, k) + separator + scaled(v.y, k) + separator + scaled(v.z, k);
}

/// A box with normals and texture coordinates on a larger square, beside the origin.
std::string boxObj(int k) {
    std::string obj = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    int vertices = 0, normals = 0;
    const auto face = [&](const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
        for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v})
            obj += "v " + scaled(p, k, " ") + "\n";
        obj += "vn " + scaled(glm::normalize(glm::cross(u, v)), 0, " ") + "\nf";
        ++normals;
        for (int i = 1; i <= 4; ++i) obj += fmt::format(" {}/{}/{}", vertices + i, i, normals);
        obj += "\n";
        vertices += 4;
    };
    const glm::dvec3 low(0.3, 0.1, -0.4), x(0.7, 0, 0), y(0, 0.6, 0), z(0, 0, 0.5);
    face(low, y, x);
    face(low, z, y);
    face(low, x, z);
    face(low + x + y + z, -x, -y);
    face(low + x + y + z, -y, -z);
    face(low + x + y + z, -z, -x);
    face({-1.1, 0.07, 1.3}, {2.9, 0, 0}, {0, 0, -2.3});
    return obj;
}

/// Area light, falloff, a mirror, transparency, a moving sphere, generated meshes, a transform.
std::string room(int k, bool withFalloff) {
    const auto vector = [&](const glm::dvec3& v) { return "[" + scaled(v, k, ", ") + "]"; };
    // Falloff divides by the square of a distance.
    const std::string color = withFalloff ? scaled(0.9, 2 * k) : "0.4";
    const std::string light = "[" + color + ", " + color + ", " + color + "]";
    const std::string falloff = withFalloff ? "\nfalloff = \"inverse_square\"" : "";
    return "version = 1\n[[camera]]\nlook_from = " + vector({0.4, 1.1, 3.1}) +
           "\nlook_at = " + vector({0.4, 0.3, 0}) +
           "\n[[mesh]]\nfile = \"box.obj\"\nmaterial = \"mirror\"\n[[mesh]]\ngenerate = { shape = \"box\", "
           "size = " +
           vector({0.3, 0.4, 0.2}) +
           " }\ntransform = { rotate = [10, 20, 30], translate = " + vector({-0.6, 0.5, 0.6}) +
           " }\n[[mesh]]\ngenerate = { shape = \"uv_sphere\", radius = " + scaled(0.3, k) +
           " }\ntransform = { translate = " + vector({1.4, 0.5, 0.7}) +
           " }\nmaterial = \"glass\"\n[[sphere]]\ncenter = " + vector({-0.3, 0.45, -0.3}) +
           "\nradius = " + scaled(0.35, k) +
           "\nmaterial = \"board\"\n[material.mirror]\nkd = [0.3, 0.3, 0.3]\nks = [0.4, 0.4, 0.4]\n"
           "shininess = 20\n[material.glass]\nkd = [0.6, 0.2, 0.2]\nopacity = "
           "0.4\n[material.board]\nkd_texture = { "
           "generate = \"checker\", cells = [8, 4] }\n[[light]]\ntype = \"parallelogram\"" +
           falloff + "\ncorner = " + vector({-0.2, 2.0, 0.1}) + "\nedges = [" + vector({0.5, 0, 0}) + ", " +
           vector({0, 0, 0.5}) + "]\ncolors = [" + light + ", " + light + ", " + light + ", " + light +
           "]\n[[light]]\ntype = \"segment\"" + falloff + "\nendpoints = [" + vector({-1, 1, 2}) + ", " +
           vector({-1, 1.5, 2}) + "]\ncolors = [" + light + ", " + light + "]\n";
}

RgbImage pictureOf(const std::string& path) {
    Diagnostics notes;
    RequestOverrides overrides;
    overrides.width = overrides.height = kSize;
    overrides.spp = 1;
    return renderImage(openRequest(path, overrides, notes)).mean;
}

/// Compares with the picture at scale 1. Positions are rounded to `digits` binary digits, which moves edges,
/// and the samples are where they were: those beside an edge may see the other side.
void expectSame(const RgbImage& image, const RgbImage& reference, int digits, int k, double& worst) {
    int different = 0;
    double sum = 0.0, brightness = 0.0;
    const double tolerance = 16.0 * std::ldexp(1.0, -digits);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        ASSERT_TRUE(math::isFinite(image.pixels[i])) << k;
        const double difference = math::distance(image.pixels[i], reference.pixels[i]);
        brightness += static_cast<double>(image.pixels[i].x);
        if (difference > tolerance)
            ++different;
        else
            sum += difference;
    }
    EXPECT_GT(brightness, 0.02 * kSize * kSize) << "10^" << k << " is black";
    EXPECT_LE(different, 2) << "of " << kSize * kSize << " pixels at 10^" << k;
    updateWorst(worst, sum / (kSize * kSize));
}

/// Floats below 2^-126 have fewer digits: their spacing is 2^-149.
int digitsAt(int k) { return std::min(24, static_cast<int>(std::floor(149.0 + k * std::log2(10.0)))); }

TEST(Scale, ABareMeshLooksTheSameAtEveryScale) {
    const TemporaryFolder folder;
    const RgbImage reference = pictureOf(folder.write("box.obj", boxObj(0)));
    double worst = 0.0;
    for (int k = -40; k <= 30; ++k)
        expectSame(pictureOf(folder.write("box.obj", boxObj(k))), reference, digitsAt(k), k, worst);
    reportDeviation("a bare mesh scaled by 10^-40 to 10^30, mean", worst, "absolute");
}

TEST(Scale, ASceneLooksTheSameAtEveryScale) {
    const TemporaryFolder folder;
    for (const bool withFalloff : {false, true}) {
        const auto pictureAt = [&](int k) {
            folder.write("box.obj", boxObj(k));
            return pictureOf(folder.write("room.toml", room(k, withFalloff)));
        };
        const RgbImage reference = pictureAt(0);
        double worst = 0.0;
        // The colours of lights with falloff must be floats with all digits, too.
        for (int k = withFalloff ? -18 : -40; k <= (withFalloff ? 18 : 30); ++k)
            expectSame(pictureAt(k), reference, digitsAt(k), k, worst);
        reportDeviation(withFalloff ? "a scene with falloff scaled by 10^-18 to 10^18, mean"
                                    : "a scene with area lights scaled by 10^-40 to 10^30, mean",
                        worst, "absolute");
    }
}

TEST(Scale, SamplesPerLengthAreCapped) {
    const TemporaryFolder folder;
    const std::string path = folder.write("room.toml", room(6, false));
    folder.write("box.obj", boxObj(6));
    RequestOverrides overrides;
    overrides.settings = {{"light_sample_count", "per_length", {}}};
    Diagnostics notes;
    const RenderRequest request = openRequest(path, overrides, notes);
    ASSERT_FALSE(notes.empty());
    EXPECT_NE(
        notes.back().message.find("2 of 2 lights take the most samples, 4096 along a segment or 100 x 100"),
        std::string::npos)
        << notes.back().message;
}

}  // namespace
}  // namespace rayscope::test
