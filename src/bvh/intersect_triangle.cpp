#include "bvh/intersect_triangle.h"

#include <utility>

namespace rayscope {
namespace {

/// a·b − c·d with an error of at most 1.5 ulp (Kahan; Jeannerod, Louvet, Muller 2013), so with the exact
/// sign.
double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// Sign of p.x·q.y − p.y·q.x; zero is decided as if both points were moved by (−ε, −ε²).
int edgeSign(double edge, const ShearedVertex& p, const ShearedVertex& q) {
    if (edge != 0.0) return edge > 0.0 ? 1 : -1;
    if (p.y != q.y) return p.y > q.y ? 1 : -1;
    return (q.x > p.x) - (q.x < p.x);
}

}  // namespace

ShearedRay::ShearedRay(const Ray& ray) : origin(ray.origin) {
    const glm::vec3 length = glm::abs(ray.direction);
    kz = length.x > length.y ? (length.x > length.z ? 0 : 2) : (length.y > length.z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    if (ray.direction[kz] < 0.0f) std::swap(kx, ky);  // keeps the winding
    const double z = ray.direction[kz];
    shearX = ray.direction[kx] / z;
    shearY = ray.direction[ky] / z;
    scaleZ = 1.0 / z;
}

bool intersectSheared(const ShearedRay& ray, const ShearedVertex& a, const ShearedVertex& b,
                      const ShearedVertex& c, TriangleHit& hit) {
    const double u = differenceOfProducts(c.x, b.y, c.y, b.x);
    const double v = differenceOfProducts(a.x, c.y, a.y, c.x);
    const double w = differenceOfProducts(b.x, a.y, b.y, a.x);
    const int side = edgeSign(u, c, b);
    if (side == 0 || edgeSign(v, a, c) != side || edgeSign(w, b, a) != side) return false;

    const double det = u + v + w;
    hit.t = (u * a.z + v * b.z + w * c.z) * ray.scaleZ / det;
    hit.u = v / det;
    hit.v = w / det;
    return std::isfinite(hit.t);
}

}  // namespace rayscope
