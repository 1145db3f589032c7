#pragma once
// The usual alternatives to the tracer's triangle test. They serve as controls of the laboratory: it has to
// show where they fail.
#include <rayscope/ray.h>

#include <cmath>

namespace rayscope::measure {

/// A tolerance below which a determinant counts as zero, and the least t.
template <class Real>
struct MoellerTrumbore {
    using Vector = glm::vec<3, Real>;
    Real epsilon;
    struct Found {
        Real t, u, v;
    };

    /// Möller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", both sides.
    bool operator()(const Vector& origin, const Vector& direction, const glm::vec3& a, const glm::vec3& b,
                    const glm::vec3& c, Found& found) const {
        const Vector corner(a), edge1 = Vector(b) - corner, edge2 = Vector(c) - corner;
        const Vector p = glm::cross(direction, edge2);
        const Real det = glm::dot(edge1, p);
        if (det == Real(0) || std::abs(det) < epsilon) return false;
        const Real inverse = Real(1) / det;
        const Vector s = origin - corner;
        found.u = glm::dot(s, p) * inverse;
        if (!(found.u >= Real(0) && found.u <= Real(1))) return false;
        const Vector q = glm::cross(s, edge1);
        found.v = glm::dot(direction, q) * inverse;
        if (!(found.v >= Real(0) && found.u + found.v <= Real(1))) return false;
        found.t = glm::dot(edge2, q) * inverse;
        return found.t > epsilon && std::isfinite(found.t);
    }
};

inline constexpr MoellerTrumbore<float> kFloatControl{0.0f};
inline constexpr MoellerTrumbore<float> kEpsilonControl{1e-6f};
inline constexpr MoellerTrumbore<double> kDoubleControl{0.0};

}  // namespace rayscope::measure
