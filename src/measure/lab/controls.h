#pragma once
// Textbook triangle tests as controls: a robustness test must detect their failures.
#include <rayscope/ray.h>

#include <cmath>

namespace rayscope::measure {

template <class Real>
struct MoellerTrumbore {
    using Vector = glm::vec<3, Real>;
    Real epsilon;  ///< determinants and t up to this count as zero
    struct Hit {
        Real t, u, v;
    };

    /// Möller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", both sides.
    bool operator()(const Vector& origin, const Vector& direction, const glm::vec3& a, const glm::vec3& b,
                    const glm::vec3& c, Hit& hit) const {
        const Vector corner(a), edge1 = Vector(b) - corner, edge2 = Vector(c) - corner;
        const Vector p = glm::cross(direction, edge2);
        const Real det = glm::dot(edge1, p);
        if (det == Real(0) || std::abs(det) < epsilon) return false;
        const Real inverse = Real(1) / det;
        const Vector s = origin - corner;
        hit.u = glm::dot(s, p) * inverse;
        if (!(hit.u >= Real(0) && hit.u <= Real(1))) return false;
        const Vector q = glm::cross(s, edge1);
        hit.v = glm::dot(direction, q) * inverse;
        if (!(hit.v >= Real(0) && hit.u + hit.v <= Real(1))) return false;
        hit.t = glm::dot(edge2, q) * inverse;
        return hit.t > epsilon && std::isfinite(hit.t);
    }
};

inline constexpr MoellerTrumbore<float> kFloatControl{0.0f};
inline constexpr MoellerTrumbore<float> kEpsilonControl{1e-6f};
inline constexpr MoellerTrumbore<double> kDoubleControl{0.0};

}  // namespace rayscope::measure
