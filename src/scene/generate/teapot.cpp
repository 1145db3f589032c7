// The Utah teapot of Martin Newell, 1975: 32 bicubic Bézier patches, with z up in the original coordinates.
// Body and lid are surfaces of revolution, handle and spout are symmetric, so that the 306 control points
// follow from the few below.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "scene/generate/generate.h"
#include "scene/load_step.h"

namespace rayscope::scene {

namespace {

using Vec3 = glm::dvec3;
/// points[row][column]: rows run along v, columns along u.
using Patch = std::array<std::array<Vec3, 4>, 4>;
/// Four points (distance from the axis, height).
using Profile = std::array<glm::dvec2, 4>;

/// Newell's ratio of the inner control points of a quarter circle (the best fit would be 0.5523).
constexpr double kQuarterCircle = 0.56;

// Steps of resolution 16; other resolutions scale them. Together they make 15,704 triangles.
constexpr int kAround = 16, kHandleAround = 16, kSpoutAround = 14;

struct Revolved {
    Profile profile;
    int steps;
};
constexpr std::array<Revolved, 6> kRevolved{{
    {{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}}, 8},  // rim
    {{{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}}, 20},           // upper body
    {{{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}, 20},           // lower body
    {{{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}}, 12},          // bottom
    {{{{0.0, 3.15}, {0.8, 3.15}, {0.0, 2.85}, {0.2, 2.7}}}, 16},            // knob of the lid
    {{{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}, 16},             // lid
}};

/// Half of a part of the handle or spout; each row is half a ring, from y = 0 through y > 0 back to y = 0.
struct Tube {
    Vec3 rings[4][4];
    int around, steps;
};
constexpr std::array<Tube, 4> kTubes{{
    {{{{-1.6, 0, 2.025}, {-1.6, 0.3, 2.025}, {-1.5, 0.3, 2.25}, {-1.5, 0, 2.25}},  // handle, upper half
      {{-2.3, 0, 2.025}, {-2.3, 0.3, 2.025}, {-2.5, 0.3, 2.25}, {-2.5, 0, 2.25}},
      {{-2.7, 0, 2.025}, {-2.7, 0.3, 2.025}, {-3.0, 0.3, 2.25}, {-3.0, 0, 2.25}},
      {{-2.7, 0, 1.8}, {-2.7, 0.3, 1.8}, {-3.0, 0.3, 1.8}, {-3.0, 0, 1.8}}},
     kHandleAround,
     15},
    {{{{-2.7, 0, 1.8}, {-2.7, 0.3, 1.8}, {-3.0, 0.3, 1.8}, {-3.0, 0, 1.8}},  // handle, lower half
      {{-2.7, 0, 1.575}, {-2.7, 0.3, 1.575}, {-3.0, 0.3, 1.35}, {-3.0, 0, 1.35}},
      {{-2.5, 0, 1.125}, {-2.5, 0.3, 1.125}, {-2.65, 0.3, 0.9375}, {-2.65, 0, 0.9375}},
      {{-2.0, 0, 0.9}, {-2.0, 0.3, 0.9}, {-1.9, 0.3, 0.6}, {-1.9, 0, 0.6}}},
     kHandleAround,
     16},
    {{{{1.7, 0, 0.6}, {1.7, 0.66, 0.6}, {1.7, 0.66, 1.425}, {1.7, 0, 1.425}},  // spout, lower half
      {{3.1, 0, 0.825}, {3.1, 0.66, 0.825}, {2.6, 0.66, 1.425}, {2.6, 0, 1.425}},
      {{2.4, 0, 2.025}, {2.4, 0.25, 2.025}, {2.3, 0.25, 2.1}, {2.3, 0, 2.1}},
      {{3.3, 0, 2.4}, {3.3, 0.25, 2.4}, {2.7, 0.25, 2.4}, {2.7, 0, 2.4}}},
     kSpoutAround,
     18},
    {{{{3.3, 0, 2.4}, {3.3, 0.25, 2.4}, {2.7, 0.25, 2.4}, {2.7, 0, 2.4}},  // spout, upper half
      {{3.525, 0, 2.49375}, {3.525, 0.25, 2.49375}, {2.8, 0.25, 2.475}, {2.8, 0, 2.475}},
      {{3.45, 0, 2.5125}, {3.45, 0.15, 2.5125}, {2.9, 0.15, 2.475}, {2.9, 0, 2.475}},
      {{3.2, 0, 2.4}, {3.2, 0.15, 2.4}, {2.8, 0.15, 2.4}, {2.8, 0, 2.4}}},
     kSpoutAround,
     19},
}};

Patch revolve(const Profile& profile, int quarter) {
    constexpr std::array<glm::ivec2, 5> kCompass{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
    const glm::dvec2 from(kCompass[static_cast<std::size_t>(quarter)]);
    const glm::dvec2 to(kCompass[static_cast<std::size_t>(quarter) + 1]);
    const std::array<glm::dvec2, 4> arc{from, from + kQuarterCircle * to, to + kQuarterCircle * from, to};
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            patch[row][column] = Vec3(profile[row].x * arc[column], profile[row].y);
    return patch;
}

/// One half of a tube. The other half is its mirror image with reversed columns, so that both have the same
/// orientation.
Patch halfTube(const Tube& tube, bool mirrored) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const Vec3 p = tube.rings[row][mirrored ? 3 - column : column];
            patch[row][column] = {p.x, mirrored ? -p.y : p.y, p.z};
        }
    return patch;
}

using Weights = std::array<double, 4>;
Weights bernstein(double t) {
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}
Weights bernsteinSlope(double t) {
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

Vec3 blend(const Patch& patch, const Weights& u, const Weights& v) {
    Vec3 sum(0.0);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) sum += v[row] * u[column] * patch[row][column];
    return sum;
}

/// Of the progress, per patch.
constexpr std::size_t kStepUnits = 100;

/// Joins patches into one mesh. Neighbours evaluate their common edge from the same control points with the
/// same weights, so that its vertices are bit-identical and shared by look-up.
class PatchMesh {
  public:
    explicit PatchMesh(LoadStep& step) : step_(step) {}
    /// `outward` is 1 or −1: the sign of du × dv along the outward normal.
    void add(const Patch& patch, int stepsU, int stepsV, double outward) {
        std::vector<std::uint32_t> grid;
        for (int j = 0; j <= stepsV; ++j) {
            const double v = static_cast<double>(j) / stepsV;
            step_.advanceTo(patches_ * kStepUnits + static_cast<std::size_t>(v * kStepUnits));
            for (int i = 0; i <= stepsU; ++i)
                grid.push_back(vertexAt(patch, static_cast<double>(i) / stepsU, v, outward));
        }
        ++patches_;
        const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (stepsU + 1) + i)]; };
        for (int j = 0; j < stepsV; ++j)
            for (int i = 0; i < stepsU; ++i) {
                addTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), outward);
                addTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), outward);
            }
    }

    MeshData finish() {
        for (glm::vec3& normal : mesh_.normals) normal = glm::normalize(normal);
        return std::move(mesh_);
    }

  private:
    std::uint32_t vertexAt(const Patch& patch, double u, double v, double outward) {
        const Weights bu = bernstein(u), bv = bernstein(v), du = bernsteinSlope(u), dv = bernsteinSlope(v);
        const Vec3 alongU = blend(patch, du, bv), alongV = blend(patch, bu, dv);
        Vec3 normal = glm::cross(alongU, alongV);
        // At a pole the edge v = const is one point; the normal is the limit from inside the patch.
        if (alongU == Vec3(0.0)) normal = (v < 0.5 ? 1.0 : -1.0) * glm::cross(blend(patch, du, dv), alongV);
        normal = outward * glm::normalize(normal);
        // From z up to y up, by a rotation about the x axis. Adding 0 turns −0 into 0.
        const auto upright = [](const Vec3& p) { return glm::vec3(p.x, p.z, -p.y) + 0.0f; };
        const glm::vec3 position = upright(blend(patch, bu, bv));
        const std::array key{std::bit_cast<std::uint32_t>(position.x),
                             std::bit_cast<std::uint32_t>(position.y),
                             std::bit_cast<std::uint32_t>(position.z)};
        const auto [found, isNew] =
            vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (isNew) {
            mesh_.positions.push_back(position);
            mesh_.normals.emplace_back(0.0f);
        }
        mesh_.normals[found->second] += upright(normal);
        return found->second;
    }

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, double outward) {
        if (a == b || b == c || c == a) return;  // at a pole
        mesh_.triangles.push_back(outward > 0.0 ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b));
    }

    LoadStep& step_;
    std::size_t patches_ = 0;
    MeshData mesh_;
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> vertices_;
};

}  // namespace

MeshData generate(const TeapotShape& shape, const LoadControl& control) {
    // At least two steps, so that half a tube is not flat.
    const auto scaled = [&](int steps) { return std::max(2, (steps * shape.resolution + 8) / 16); };
    const std::size_t patches = 4 * std::size(kRevolved) + 2 * std::size(kTubes);
    LoadStep step(control, "generating a teapot", patches * kStepUnits);
    PatchMesh mesh(step);
    for (const Revolved& part : kRevolved)
        for (int quarter = 0; quarter < 4; ++quarter)
            mesh.add(revolve(part.profile, quarter), scaled(kAround), scaled(part.steps), -1.0);
    for (const Tube& tube : kTubes)
        for (const bool mirrored : {false, true})
            mesh.add(halfTube(tube, mirrored), scaled(tube.around), scaled(tube.steps),
                     tube.rings[0][0].x < 0 ? 1.0 : -1.0);
    return mesh.finish();
}

}  // namespace rayscope::scene
