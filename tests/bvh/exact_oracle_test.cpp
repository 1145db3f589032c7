// The triangle, box and closest-hit tests against rational arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bvh/intersect/intersect_box.h"
#include "bvh/intersect/intersect_triangle.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 rational(const glm::vec3& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

Rational3 difference(const Rational3& a, const Rational3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

mpq_class determinant(const Rational3& a, const Rational3& b, const Rational3& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Signed volumes between the ray and the three edges: all of one sign inside, one zero on an edge.
struct ExactTriangle {
    mpq_class u, v, w, t;
    bool onEdge, inside;

    ExactTriangle(const Ray& ray, const glm::vec3& va, const glm::vec3& vb, const glm::vec3& vc) {
        const Rational3 o = rational(ray.origin), d = rational(ray.direction);
        const Rational3 a = difference(rational(va), o), b = difference(rational(vb), o),
                        c = difference(rational(vc), o);
        u = determinant(d, c, b), v = determinant(d, a, c), w = determinant(d, b, a);
        onEdge = sgn(u) * sgn(v) * sgn(w) == 0;
        inside = !onEdge && sgn(u) == sgn(v) && sgn(v) == sgn(w);
        if (inside) t = determinant(a, c, b) / (u + v + w);
    }
};

TEST(ExactOracle, TriangleIsClassifiedExactlyAndTIsWithinItsBound) {
    Random random(1);
    int inside = 0, outside = 0;
    double worst = 0.0;
    for (int i = 0; i < 60000; ++i) {
        const double distance = std::pow(10.0, random.real(0, 3));
        const glm::vec3 a = random.inCube(), b = random.inCube(), c = random.inCube();
        Ray ray;
        ray.origin = glm::vec3(distance * random.onSphere());
        const double aside = (random.integer(2) ? 1 : -1) * std::pow(10.0, random.real(-8, -1));
        const glm::dvec3 da = a, db = b, dc = c;
        ray.direction =
            glm::vec3(da + random.real() * (db - da) + aside * (dc - da) - glm::dvec3(ray.origin));
        const ExactTriangle exact(ray, a, b, c);
        if (exact.onEdge) continue;
        bvh::TriangleHit hit{};
        ASSERT_EQ(bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData(ray)), a, b, c, hit), exact.inside)
            << text(ray);
        ++(exact.inside ? inside : outside);
        if (!exact.inside) continue;
        const mpq_class error = abs(mpq_class(hit.t) - exact.t) / abs(exact.t);
        const glm::dvec3 normal = glm::normalize(glm::cross(db - da, dc - da));
        const double grazing = std::abs(glm::dot(normal, glm::normalize(glm::dvec3(ray.direction))));
        // The sheared corners err by 2^-52 of their distance, which a slope turns into error along the ray;
        // eight more roundings and the conditioning of the weights fit into the factor.
        worst = std::max(worst, error.get_d() * grazing * 0x1p48);
        ASSERT_LE(error.get_d(), 0x1p-48 / grazing) << text(ray);
        ASSERT_NEAR(hit.u, mpq_class(exact.v / (exact.u + exact.v + exact.w)).get_d(), 1e-9);
        ASSERT_NEAR(hit.v, mpq_class(exact.w / (exact.u + exact.v + exact.w)).get_d(), 1e-9);
    }
    EXPECT_GT(inside, 10000);
    EXPECT_GT(outside, 10000);
    EXPECT_GE(worst, 0.01) << "the bound is not needlessly large";
}

/// Whether the exact line intersects the closed box for some t in [tMin, tMax].
bool exactlyIntersects(const bvh::BinaryNode& box, const Ray& ray) {
    mpq_class enter = ray.tMin, leave = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const mpq_class o = ray.origin[axis], d = ray.direction[axis], low = box.lower[axis],
                        high = box.upper[axis];
        if (d == 0) {
            if (o < low || o > high) return false;
            continue;
        }
        mpq_class near = (low - o) / d, far = (high - o) / d;
        if (near > far) std::swap(near, far);
        if (near > enter) enter = near;
        if (far < leave) leave = far;
    }
    return enter <= leave;
}

bvh::BinaryNode someBox(Random& random, double size) {
    bvh::BinaryNode box{};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = size * random.real(-1, 1);
        box.lower[axis] = static_cast<float>(low);
        const bool isFlat = random.integer(6) == 0;
        box.upper[axis] =
            isFlat ? box.lower[axis] : static_cast<float>(low + size * std::exp2(-random.real(0, 12)));
    }
    return box;
}

/// Aimed at corners, edges and faces, along and inside the planes of the box, with directions of any length.
Ray rayAtBox(Random& random, const bvh::BinaryNode& box, double size) {
    Ray ray;
    ray.tMax = std::numeric_limits<float>::max();
    glm::dvec3 target;
    for (int axis = 0; axis < 3; ++axis) {
        const double weight = random.integer(3) ? random.integer(2) : random.real();
        target[axis] = box.lower[axis] + weight * (double(box.upper[axis]) - box.lower[axis]);
    }
    ray.origin = glm::vec3(size * std::exp2(random.real(-3, 10)) * random.onSphere());
    glm::dvec3 direction = target - glm::dvec3(ray.origin);
    if (random.integer(2)) direction *= std::exp2(random.integer(60) - 30) / glm::length(direction);
    ray.direction = glm::vec3(direction);
    for (int axis = 0; axis < 3; ++axis) {
        const int special = random.integer(12);
        if (special > 2) continue;
        ray.origin[axis] = static_cast<float>(target[axis]);
        ray.direction[axis] = special == 0   ? 0.0f
                              : special == 1 ? -0.0f
                                             : std::ldexp(1.0f, -random.integer(149));
    }
    if (random.integer(4) == 0) ray.tMax = static_cast<float>(glm::length(target) / glm::length(direction));
    return ray;
}

TEST(ExactOracle, BoxTestIsConservative) {
    Random random(2);
    int hits = 0, falseHits = 0, misses = 0;
    for (int i = 0; i < 200000; ++i) {
        const double size = std::exp2(random.integer(121) - 60);
        const bvh::BinaryNode box = someBox(random, size);
        const Ray ray = rayAtBox(random, box, size);
        if (ray.direction == glm::vec3(0.0f)) continue;
        const bvh::BoxRay boxRay(bvh::rayData(ray));
        float entry;
        const bool found = bvh::intersectBox(bvh::planes(box), boxRay, boxRay.tMax, entry);
        const bool exact = exactlyIntersects(box, ray);
        if (exact) {
            ASSERT_TRUE(found) << text(ray);
        }
        hits += exact;
        misses += !exact;
        falseHits += found && !exact;
    }
    EXPECT_GT(hits, 50000);
    EXPECT_GT(misses, 20000);
    EXPECT_GT(falseHits, 0) << "rays at corners should hit the padding";
}

/// The interval of a box that contains another one contains the other's interval, to the last bit.
TEST(ExactOracle, BoxTestIsMonotone) {
    Random random(3);
    int hits = 0;
    for (int i = 0; i < 300000; ++i) {
        const double size = std::exp2(random.integer(121) - 60);
        const bvh::BinaryNode inner = someBox(random, size);
        const Ray ray = rayAtBox(random, inner, size);
        if (ray.direction == glm::vec3(0.0f)) continue;
        bvh::BinaryNode outer = inner;
        for (int axis = 0; axis < 3; ++axis) {
            if (random.integer(2))
                outer.lower[axis] -= static_cast<float>(size * std::exp2(-random.real(0, 30)));
            if (random.integer(2))
                outer.upper[axis] += static_cast<float>(size * std::exp2(-random.real(0, 30)));
        }
        const bvh::BoxRay boxRay(bvh::rayData(ray));
        float entry, outerEntry;
        if (!bvh::intersectBox(bvh::planes(inner), boxRay, boxRay.tMax, entry)) continue;
        ++hits;
        ASSERT_TRUE(bvh::intersectBox(bvh::planes(outer), boxRay, boxRay.tMax, outerEntry)) << text(ray);
        ASSERT_LE(outerEntry, entry) << text(ray);
    }
    EXPECT_GT(hits, 50000);
}

}  // namespace
}  // namespace rayscope::test
