#pragma once
// Closed forms, independent of the tracer.
#include <rayscope/vector.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace rayscope::test {

/// Cumulative normal distribution.
inline double normalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// The mean of c(s) (n·l) along a segment light from `a` to `b` above the horizon of a receiver at the origin
/// with normal n, where c(s) is linear from c0 to c1. With e = a, unit direction t and r(s)² = s² + 2 c s + q
/// the integrand is (n·e + s n·t)(1, s) / r(s), whose primitives are elementary.
inline double segmentMean(const glm::dvec3& n, const glm::dvec3& a, const glm::dvec3& b, double c0,
                          double c1) {
    const double length = glm::distance(a, b);
    const glm::dvec3 t = (b - a) / length;
    const double na = glm::dot(n, a), nt = glm::dot(n, t), c = glm::dot(a, t), q = glm::dot(a, a);
    struct Primitives {
        double one, s, ss;  ///< of 1 / r, s / r and s² / r
    };
    const auto at = [&](double s) {
        const double r = std::sqrt(s * s + 2.0 * c * s + q), log = std::log(s + c + r);
        return Primitives{log, r - c * log, 0.5 * (s - 3.0 * c) * r + 0.5 * (3.0 * c * c - q) * log};
    };
    const Primitives from = at(0.0), to = at(length);
    const double one = to.one - from.one, s = to.s - from.s, ss = to.ss - from.ss;
    return (c0 * (na * one + nt * s) + (c1 - c0) / length * (na * s + nt * ss)) / length;
}

/// The mean of (n·l) / r² along a segment light.
inline double segmentMeanInverseSquare(const glm::dvec3& n, const glm::dvec3& a, const glm::dvec3& b) {
    const double length = glm::distance(a, b);
    const glm::dvec3 t = (b - a) / length;
    const double na = glm::dot(n, a), nt = glm::dot(n, t), c = glm::dot(a, t), q = glm::dot(a, a);
    const auto primitive = [&](double s) {
        const double r = std::sqrt(s * s + 2.0 * c * s + q);
        return (na - nt * c) * (s + c) / ((q - c * c) * r) - nt / r;
    };
    return (primitive(length) - primitive(0.0)) / length;
}

/// The mean of (n·l) over the rectangle [x0, x1] × [y0, y1] at height h above a receiver at the origin that
/// faces it.
inline double rectangleMean(double x0, double x1, double y0, double y1, double h) {
    const auto primitive = [h](double x, double y) {
        const double r = std::sqrt(x * x + y * y + h * h);
        return h * (x * std::asinh(y / std::hypot(x, h)) + y * std::asinh(x / std::hypot(y, h)) -
                    h * std::atan(x * y / (h * r)));
    };
    const double sum = primitive(x1, y1) - primitive(x0, y1) - primitive(x1, y0) + primitive(x0, y0);
    return sum / ((x1 - x0) * (y1 - y0));
}

/// Solid angle of the rectangle [x0, x1] × [y0, y1] at height h above the origin: the integral of (n·l) / r²
/// over its area, for a receiver that faces it.
inline double rectangleSolidAngle(double x0, double x1, double y0, double y1, double h) {
    const auto primitive = [h](double x, double y) {
        return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
    };
    return primitive(x1, y1) - primitive(x0, y1) - primitive(x1, y0) + primitive(x0, y0);
}

/// Integral of f over the unit square by Gauss and Legendre's rule of five points in 32 × 32 cells; exact to
/// rounding for functions as smooth as a light seen from outside it.
template <class F>
double integrateUnitSquare(F&& f) {
    constexpr int kCells = 32;
    static constexpr double kNodes[5] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                         0.9061798459386640};
    static constexpr double kWeights[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                           0.4786286704993665, 0.2369268850561891};
    double sum = 0.0;
    for (int j = 0; j < kCells; ++j)
        for (int i = 0; i < kCells; ++i)
            for (int b = 0; b < 5; ++b)
                for (int a = 0; a < 5; ++a)
                    sum += kWeights[a] * kWeights[b] *
                           f((i + 0.5 + 0.5 * kNodes[a]) / kCells, (j + 0.5 + 0.5 * kNodes[b]) / kCells);
    return sum / (4.0 * kCells * kCells);
}

/// Area of the part of the unit square [x, x + 1] × [y, y + 1] where dot(normal, p) < offset, by clipping.
inline double halfPlaneInPixel(int x, int y, const glm::dvec2& normal, double offset) {
    const glm::dvec2 corners[4] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    std::vector<glm::dvec2> kept;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % 4];
        const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
        if (da < 0.0) kept.push_back(a);
        if ((da < 0.0) != (db < 0.0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    double area = 0.0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const glm::dvec2 a = kept[i], b = kept[(i + 1) % kept.size()];
        area += 0.5 * (a.x * b.y - b.x * a.y);
    }
    return area;
}

/// The fraction of a disk of radius 1 that lies on the side x < t.
inline double diskBelow(double t) {
    if (t <= -1.0) return 0.0;
    if (t >= 1.0) return 1.0;
    return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / std::numbers::pi;
}

}  // namespace rayscope::test
