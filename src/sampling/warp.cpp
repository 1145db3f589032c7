#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope::sampling {

namespace {

/// Rational approximations of the normal quantile, relative error 1e-16 (Wichura 1988, Algorithm AS 241,
/// PPND16).
double polynomial(const double (&c)[8], double x) {
    double sum = c[7];
    for (int i = 6; i >= 0; --i) sum = sum * x + c[i];
    return sum;
}

double normalQuantile(double p) {
    static constexpr double a[8] = {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                                    1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                                    3.3430575583588128105e4, 2.5090809287301226727e3};
    static constexpr double b[8] = {1.0,
                                    4.2313330701600911252e1,
                                    6.8718700749205790830e2,
                                    5.3941960214247511077e3,
                                    2.1213794301586595867e4,
                                    3.9307895800092710610e4,
                                    2.8729085735721942674e4,
                                    5.2264952788528545610e3};
    static constexpr double c[8] = {1.42343711074968357734e0,  4.63033784615654529590e0,
                                    5.76949722146069140550e0,  3.64784832476320460504e0,
                                    1.27045825245236838258e0,  2.41780725177450611770e-1,
                                    2.27238449892691845833e-2, 7.74545014278341407640e-4};
    static constexpr double d[8] = {1.0,
                                    2.05319162663775882187e0,
                                    1.67638483018380384940e0,
                                    6.89767334985100004550e-1,
                                    1.48103976427480074590e-1,
                                    1.51986665636164571966e-2,
                                    5.47593808499534494600e-4,
                                    1.05075007164441684324e-9};
    static constexpr double e[8] = {6.65790464350110377720e0,  5.46378491116411436990e0,
                                    1.78482653991729133580e0,  2.96560571828504891230e-1,
                                    2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                    2.71155556874348757815e-5, 2.01033439929228813265e-7};
    static constexpr double f[8] = {1.0,
                                    5.99832206555887937690e-1,
                                    1.36929880922735805310e-1,
                                    1.48753612908506148525e-2,
                                    7.86869131145613259100e-4,
                                    1.84631831751005468180e-5,
                                    1.42151175831644588870e-7,
                                    2.04426310338993978564e-15};
    const double q = p - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(a, r) / polynomial(b, r);
    }
    const double r = std::sqrt(-std::log(q < 0.0 ? p : 1.0 - p));
    const double tail = r <= 5.0 ? polynomial(c, r - 1.6) / polynomial(d, r - 1.6)
                                 : polynomial(e, r - 5.0) / polynomial(f, r - 5.0);
    return q < 0.0 ? -tail : tail;
}

/// Shirley and Chiu 1997, "A Low Distortion Map Between Disk and Square".
glm::dvec2 concentricDisk(const glm::dvec2& u) {
    const glm::dvec2 p = 2.0 * u - 1.0;
    if (p.x == 0.0 && p.y == 0.0) return {0.0, 0.0};
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double radius = wide ? p.x : p.y;
    const double angle = wide ? std::numbers::pi / 4.0 * (p.y / p.x)
                              : std::numbers::pi / 2.0 - std::numbers::pi / 4.0 * (p.x / p.y);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// Chooses one of six equal triangles around the centre and maps to it uniformly.
glm::dvec2 hexagon(const glm::dvec2& u) {
    const double scaled = u.x * 6.0;
    const int sector = std::min(static_cast<int>(scaled), 5);
    const double along = scaled - sector, out = std::sqrt(u.y);
    const auto corner = [](int i) {
        const double angle = std::numbers::pi / 3.0 * i;
        return glm::dvec2(std::cos(angle), std::sin(angle));
    };
    return out * ((1.0 - along) * corner(sector) + along * corner(sector + 1));
}

}  // namespace

double normalDeviate(float u) {
    // Centre of the interval of width 2^-24 that the float represents, so that neither 0 nor 1 occurs.
    return normalQuantile(static_cast<double>(u) + 0x1p-25);
}

glm::dvec2 sampleAperture(LensShape shape, const glm::vec2& u) {
    switch (shape) {
        case LensShape::Square:
            return 2.0 * glm::dvec2(u) - 1.0;
        case LensShape::Hexagon:
            return hexagon(glm::dvec2(u));
        case LensShape::Disk:
            break;
    }
    return concentricDisk(glm::dvec2(u));
}

}  // namespace rayscope::sampling
