#include "measure/lab/exact_crossing.h"

#include <cmath>

#include "bvh/intersect/ray_data.h"
#include "measure/lab/exact_sum.h"

namespace rayscope::measure {

namespace {

/// Exact quantities of one ray.
class ExactRay {
  public:
    explicit ExactRay(const Ray& ray)
        : origin_(ray.origin),
          direction_(ray.direction),
          axes_(bvh::rayData(ray)),
          along_(direction_[axes_.kz]) {}

    float along() const { return std::abs(along_); }

    /// d · ((p − o) × (q − o)), multiplied out; the edge function of sheared p and q times along().
    ExactSum edge(const glm::vec3& p, const glm::vec3& q) const {
        ExactSum sum;
        addDeterminant(sum, direction_, p, q);
        addDeterminant(sum, direction_, origin_, p);
        addDeterminant(sum, direction_, q, origin_);
        return sum;
    }

    /// The sign of an edge function; the sheared coordinates of its end points break ties.
    int edgeSign(const ExactSum& value, const glm::vec3& p, const glm::vec3& q) const {
        if (const int sign = value.sign(); sign != 0) return sign;
        if (const int above = compareSheared(p, q, axes_.ky); above != 0) return above;
        return compareSheared(q, p, axes_.kx);
    }

  private:
    /// The sign of the difference of a sheared coordinate of two points.
    int compareSheared(const glm::vec3& p, const glm::vec3& q, int axis) const {
        ExactSum difference;
        difference.add(p[axis], along_);
        difference.subtract(q[axis], along_);
        difference.subtract(direction_[axis], p[axes_.kz]);
        difference.add(direction_[axis], q[axes_.kz]);
        return along_ > 0.0f ? difference.sign() : -difference.sign();
    }

    glm::vec3 origin_, direction_;
    bvh::kernel::RayAxes axes_;
    float along_;
};

}  // namespace

ExactCrossing::ExactCrossing(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const ExactRay exact(ray);
    const ExactSum eu = exact.edge(c, b), ev = exact.edge(a, c), ew = exact.edge(b, a);
    ExactSum det = eu;
    det += ev;
    det += ew;
    const auto along = static_cast<long double>(exact.along());
    edges[0] = eu.value() / along;
    edges[1] = ev.value() / along;
    edges[2] = ew.value() / along;
    parallel = det.sign() == 0;
    if (parallel) return;

    const int side = exact.edgeSign(eu, c, b);
    crossed = side != 0 && exact.edgeSign(ev, a, c) == side && exact.edgeSign(ew, b, a) == side;
    const long double whole = det.value();
    u = ev.value() / whole;
    v = ew.value() / whole;
    // The volume of origin and triangle, over that of direction and triangle.
    t = signedVolume(a, c, b, ray.origin).value() / -whole;
}

}  // namespace rayscope::measure
