#include "image/chromaticities.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace rayscope::image {

namespace {

/// XYZ of a chromaticity with Y = 1.
glm::dvec3 xyzOf(const Chromaticities& c, std::size_t i) {
    const double x = static_cast<double>(c[2 * i]), y = static_cast<double>(c[2 * i + 1]);
    return {x / y, 1.0, (1.0 - x - y) / y};
}

glm::dmat3 diagonal(const glm::dvec3& d) { return {{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}; }

/// RGB to XYZ, with Y = 1 for white (SMPTE RP 177).
glm::dmat3 toXyz(const Chromaticities& c) {
    const glm::dmat3 primaries(xyzOf(c, 0), xyzOf(c, 1), xyzOf(c, 2));
    return primaries * diagonal(glm::inverse(primaries) * xyzOf(c, 3));
}

bool isFinite(const glm::dmat3& m) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += m[i].x + m[i].y + m[i].z;
    return std::isfinite(sum);
}

}  // namespace

std::optional<glm::dmat3> toRec709(const Chromaticities& from) {
    // Rows of the cone response matrix of Bradford (Lam 1985).
    const glm::dmat3 cones = glm::transpose(
        glm::dmat3({0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}));
    const glm::dvec3 gain = (cones * xyzOf(kRec709, 3)) / (cones * xyzOf(from, 3));
    const glm::dmat3 matrix =
        glm::inverse(toXyz(kRec709)) * glm::inverse(cones) * diagonal(gain) * cones * toXyz(from);
    if (!isFinite(matrix)) return std::nullopt;
    return matrix;
}

bool isRec709(const Chromaticities& chromaticities) {
    return std::equal(chromaticities.begin(), chromaticities.end(), kRec709.begin(),
                      [](float a, float b) { return std::abs(a - b) < 1e-3f; });
}

}  // namespace rayscope::image
