// The head of the scene "monkey": a smooth union of ellipsoids, polygonised by naive surface nets (Gibson
// 1998): one vertex per cell that the surface crosses, at the mean of its edge crossings, and one quad per
// crossed grid edge.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/generate/generate.h"
#include "scene/load_step.h"

namespace rayscope::scene {

namespace {

using Vec3 = glm::dvec3;

/// Approximate signed distance to an ellipsoid: zero on its surface, with the right sign everywhere.
double ellipsoid(const Vec3& p, const Vec3& center, const Vec3& radii) {
    const Vec3 q = (p - center) / radii;
    const double scaled = glm::length(q), slope = glm::length(q / radii);
    return slope == 0.0 ? -std::min({radii.x, radii.y, radii.z}) : scaled * (scaled - 1.0) / slope;
}

/// Smooth union of two distances over a width of k (Quílez' quadratic smooth minimum).
double smoothUnion(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * h * h * k;
}
double smoothDifference(double a, double b, double k) { return -smoothUnion(-a, b, k); }

/// Negative inside. Symmetric in x; the face points along −z.
double monkey(Vec3 p) {
    p.x = std::abs(p.x);
    double d = ellipsoid(p, {0, 0.10, 0.08}, {0.52, 0.50, 0.52});                          // skull
    d = smoothUnion(d, ellipsoid(p, {0, -0.30, -0.30}, {0.33, 0.26, 0.30}), 0.14);         // muzzle
    d = smoothUnion(d, ellipsoid(p, {0.17, 0.20, -0.38}, {0.20, 0.09, 0.12}), 0.10);       // brow
    d = smoothDifference(d, ellipsoid(p, {0.19, 0.06, -0.50}, {0.13, 0.11, 0.12}), 0.14);  // eye socket
    d = smoothUnion(d, ellipsoid(p, {0.19, 0.05, -0.40}, {0.09, 0.08, 0.08}), 0.05);       // eye
    d = smoothDifference(d, ellipsoid(p, {0, -0.36, -0.64}, {0.24, 0.07, 0.16}), 0.10);    // mouth
    double ear = ellipsoid(p, {0.70, 0.10, 0.08}, {0.27, 0.30, 0.13});
    ear = smoothDifference(ear, ellipsoid(p, {0.74, 0.10, -0.10}, {0.19, 0.22, 0.16}),
                           0.06);  // its hollow
    return smoothUnion(d, ear, 0.08);
}

Vec3 normalAt(const Vec3& p) {
    constexpr double h = 0x1p-17;  // about the cube root of the rounding error
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 step(0.0);
        step[axis] = h;
        gradient[axis] = monkey(p + step) - monkey(p - step);
    }
    return glm::normalize(gradient);
}

class SurfaceNet {
  public:
    SurfaceNet(int cellsAcross, const LoadControl& control)
        : n_(cellsAcross + 4),
          cell_(kWidth / cellsAcross),
          values_(cube(n_ + 1)),
          vertices_(cube(n_), kNone),
          step_(control, "generating a monkey", static_cast<std::size_t>(3 * n_)) {
        for (int z = 0; z <= n_; ++z) {
            step_.advance();
            for (int y = 0; y <= n_; ++y)
                for (int x = 0; x <= n_; ++x) value(x, y, z) = monkey(pointAt({x, y, z}));
        }
    }

    MeshData build() {
        for (int z = 0; z < n_; ++z) {
            step_.advance();
            for (int y = 0; y < n_; ++y)
                for (int x = 0; x < n_; ++x) addVertex(x, y, z);
        }
        for (int z = 1; z < n_; ++z) {
            step_.advance();
            for (int y = 1; y < n_; ++y)
                for (int x = 1; x < n_; ++x)
                    for (int axis = 0; axis < 3; ++axis) addQuad({x, y, z}, axis);
        }
        return std::move(mesh_);
    }

  private:
    static constexpr double kWidth = 1.9225;
    static constexpr std::uint32_t kNone = 0xffffffffu;

    static std::size_t cube(int n) { return static_cast<std::size_t>(n) * static_cast<std::size_t>(n * n); }
    /// Shifted by a fraction of a cell, because edge crossings would coincide at grid points on the plane of
    /// symmetry.
    Vec3 pointAt(const Vec3& grid) const { return (grid - 0.5 * n_) * cell_ + Vec3(0.0, 0.0, 0.05 * cell_); }
    double& value(int x, int y, int z) {
        return values_[static_cast<std::size_t>((z * (n_ + 1) + y) * (n_ + 1) + x)];
    }
    std::uint32_t& vertex(int x, int y, int z) {
        return vertices_[static_cast<std::size_t>((z * n_ + y) * n_ + x)];
    }

    void addVertex(int x, int y, int z) {
        Vec3 sum(0.0);
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                glm::ivec3 a(x, y, z);
                a[(axis + 1) % 3] += corner & 1;
                a[(axis + 2) % 3] += corner >> 1;
                glm::ivec3 b = a;
                ++b[axis];
                const double from = value(a.x, a.y, a.z), to = value(b.x, b.y, b.z);
                if ((from < 0.0) == (to < 0.0)) continue;
                sum += glm::mix(Vec3(a), Vec3(b), from / (from - to));
                ++crossings;
            }
        if (crossings == 0) return;
        const Vec3 point = pointAt(sum / static_cast<double>(crossings));
        vertex(x, y, z) = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.emplace_back(point);
        mesh_.normals.emplace_back(normalAt(point));
    }

    /// The four cells around the grid edge that starts at `p`.
    void addQuad(glm::ivec3 p, int axis) {
        glm::ivec3 end = p, u(0), v(0);
        ++end[axis];
        u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
        const bool inside = value(p.x, p.y, p.z) < 0.0;
        if (inside == (value(end.x, end.y, end.z) < 0.0)) return;
        const auto at = [&](glm::ivec3 c) { return vertex(c.x, c.y, c.z); };
        std::array quad{at(p - u - v), at(p - v), at(p), at(p - u)};
        if (!inside) std::swap(quad[1], quad[3]);
        // Split along the shorter diagonal, for better shaped triangles.
        const auto& at3 = mesh_.positions;
        const bool useOther =
            glm::distance(at3[quad[1]], at3[quad[3]]) < glm::distance(at3[quad[0]], at3[quad[2]]);
        const std::size_t s = useOther ? 1 : 0;
        mesh_.triangles.emplace_back(quad[s], quad[s + 1], quad[s + 2]);
        mesh_.triangles.emplace_back(quad[s], quad[s + 2], quad[(s + 3) % 4]);
    }

    int n_;
    double cell_;
    std::vector<double> values_;
    std::vector<std::uint32_t> vertices_;
    LoadStep step_;
    MeshData mesh_;
};

}  // namespace

MeshData generate(const MonkeyShape& shape, const LoadControl& control) {
    return SurfaceNet(shape.resolution, control).build();
}

}  // namespace rayscope::scene
