#include "measure/many_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "bvh/isa.h"
#include "bvh/meshes.h"
#include "math/frame.h"
#include "measure/lab/exact_sum.h"
#include "trace/compile.h"
#include "trace/interaction.h"

namespace rayscope::test {
namespace {

constexpr std::size_t kBatch = 5000;

struct Place {
    int exponent = 0;
    glm::dvec3 offset{0.0};  ///< in sizes
};

std::vector<Place> places(double farthest) {
    std::vector<Place> list;
    for (const int exponent : {-60, -20, 0, 20, 40, 60}) list.push_back({exponent, {}});
    for (const double offset : {1.0, 1e3, 1e6})
        if (offset <= farthest) list.push_back({0, {offset, -offset, std::floor(0.5 * offset)}});
    if (farthest >= 1e3) list.push_back({-30, {1e3, 1e3, -1e3}});
    return list;
}

TestGeometry placed(const TestGeometry& unit, const Place& place) {
    const double scale = std::ldexp(1.0, place.exponent);
    return unit.transformed(scale, scale * place.offset);
}

/// From well inside a mesh of radius one at a vertex, or at a point of an edge.
Ray aimedRay(const TestGeometry& mesh, const Place& place, Random& random) {
    const auto triangle = static_cast<std::size_t>(random.integer(static_cast<int>(mesh.triangles.size())));
    const int k = random.integer(3);
    const glm::dvec3 a = mesh.corner(triangle, k), b = mesh.corner(triangle, (k + 1) % 3);
    const double scale = std::ldexp(1.0, place.exponent);
    glm::dvec3 inside;
    for (int axis = 0; axis < 3; ++axis) inside[axis] = (random.integer(65) - 32) / 128.0;
    Ray ray;
    ray.origin = glm::vec3(scale * (place.offset + inside));
    const int kind = random.integer(4);
    const glm::dvec3 target = kind < 2 ? a + (random.integer(257) / 256.0) * (b - a) : a;
    if (kind == 3) {  // parallel to an axis, if the line through the vertex passes well inside
        const int axis = random.integer(3);
        glm::dvec3 moved = target;
        moved[axis] = scale * place.offset[axis];
        if (glm::length(moved / scale - place.offset) < 0.5) {
            ray.origin = glm::vec3(moved);
            ray.direction = glm::vec3(random.integer(2) ? 0.0f : -0.0f);
            ray.direction[axis] = target[axis] < moved[axis] ? -1.0f : 1.0f;
            return ray;
        }
    }
    glm::dvec3 direction = target - glm::dvec3(ray.origin);
    if (random.integer(2)) direction = glm::normalize(direction / scale);
    ray.direction = glm::vec3(direction);
    return ray;
}

std::vector<Isa> kernels() {
    std::vector<Isa> list;
    for (const Isa isa : {Isa::Scalar, Isa::Sse2, Isa::Avx2, Isa::Avx512})
        if (bvh::isAvailable(isa)) list.push_back(isa);
    return list;
}

Accel accelOf(const TestGeometry& mesh, Isa isa) {
    BuildSettings settings;
    settings.isa = isa;
    return Accel::build(mesh.input(), settings);
}

/// An integer grid in the plane x + 2y + 3z = 0 and its neighbours: exactly coplanar in float.
TestGeometry tiltedPlane() {
    TestGeometry floor;
    for (int i = -8; i < 8; ++i)
        for (int j = -8; j < 8; ++j) {
            const auto at = [](int u, int v) { return glm::vec3(-2 * u - 3 * v, u, v); };
            floor.addTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            floor.addTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return floor;
}

/// Whether all vertices lie on or below the plane of every triangle, without rounding.
bool isConvex(const TestGeometry& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const glm::vec3& vertex : mesh.vertices)
            if (measure::signedVolume(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), vertex)
                    .sign() > 0)
                return false;
    return true;
}

std::shared_ptr<const trace::World> worldOf(const TestGeometry& mesh) {
    auto scene = std::make_shared<SceneDescription>();
    auto data = std::make_shared<MeshData>();
    data->positions = mesh.vertices;
    data->triangles = mesh.triangles;
    scene->materials.emplace_back();
    scene->meshes.push_back({.name = mesh.name, .data = std::move(data), .materials = {0}});
    return trace::compile({scene, Settings{}, CameraDescription{}, 1, 1, false});
}

/// One ray at a triangle and what leaves the hit point on both sides. False if it has to be left out.
bool traceSpawnedRay(const trace::World& world, const TestGeometry& mesh, bool closed, double size,
                     Random& random) {
    const auto triangle = static_cast<std::size_t>(random.integer(static_cast<int>(mesh.triangles.size())));
    const glm::dvec3 a = mesh.corner(triangle, 0), b = mesh.corner(triangle, 1), c = mesh.corner(triangle, 2);
    double u = random.real(), v = random.real();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    if (random.integer(2)) u *= std::pow(10.0, random.real(-7, 0));
    const glm::dvec3 point = a + u * (b - a) + v * (c - a);
    Ray first;
    first.origin = glm::vec3(point + size * std::pow(10.0, random.real(-1, 2)) * random.onSphere());
    first.direction = glm::vec3(point - glm::dvec3(first.origin));
    Hit hit;
    if (first.direction == glm::vec3(0.0f) || !world.closestHit(first, 0.0f, hit)) return false;
    const trace::Interaction at = trace::interactionAt(world, first, 0.0f, {}, hit);
    const glm::dvec3 p = mesh.corner(hit.primitive, 0), q = mesh.corner(hit.primitive, 1),
                     r = mesh.corner(hit.primitive, 2);
    const bool fromOutside = glm::dot(at.geometricNormal, glm::cross((q - p) / size, (r - p) / size)) > 0.0;
    const double sine = std::pow(10.0, random.real(-4, 0)), phi = random.real(0, 6.283185307179586);
    for (const bool behind : {false, true}) {
        const glm::dvec3 normal = behind ? -at.geometricNormal : at.geometricNormal;
        const math::Frame frame = math::frameAround(normal);
        const double cosine = std::sqrt(1.0 - sine * sine);
        const Ray next{
            behind ? at.originBehind() : at.originOutside(),
            glm::vec3(sine * normal + cosine * (std::cos(phi) * frame.u + std::sin(phi) * frame.v))};
        const bool inward = closed && behind == fromOutside;
        Hit second;
        const bool found = world.closestHit(next, 0.0f, second);
        // From next to an edge, or at a small angle, it may leave through the neighbour at once.
        const float rim = std::min({hit.u, hit.v, 1.0f - hit.u - hit.v});
        if (inward && (sine < 0.01 || rim < 0.01f)) continue;
        EXPECT_EQ(found, inward) << mesh.name << ": " << text(next) << " from primitive " << hit.primitive;
        if (found != inward) return false;
        if (inward) {
            EXPECT_NE(second.primitive, hit.primitive) << text(next);
        }
    }
    return true;
}

}  // namespace

std::uint64_t traceRaysAtSharedEdges(std::uint64_t count) {
    std::uint64_t shot = 0;
    Random random(23);
    std::vector<TestGeometry> units{icosphere(3, 0.0, 1), icosphere(4, 0.1, 3), needleSphere(8, 256),
                                    gridBox(16)};
    struct Target {
        TestGeometry mesh;
        Place place;
        std::vector<std::optional<Accel>> accels;  ///< by kernels, built when they are wanted
    };
    const std::vector<Isa> isas = kernels();
    std::vector<Target> targets;
    for (const TestGeometry& unit : units)
        for (const Place& place : places(1e6)) {
            targets.push_back({placed(unit, place), place, {}});
            targets.back().accels.resize(isas.size());
        }

    std::vector<Ray> rays(kBatch);
    std::vector<Hit> hits(kBatch);
    std::vector<std::uint8_t> occluded(kBatch);
    for (std::size_t round = 0; shot < count; ++round) {
        Target& target = targets[round % targets.size()];
        // Neighbouring targets take different kernels, so that few rounds see all of both.
        const std::size_t isa = (round + round / targets.size()) % isas.size();
        std::optional<Accel>& built = target.accels[isa];
        if (!built) built = accelOf(target.mesh, isas[isa]);
        const Accel& accel = *built;
        for (Ray& ray : rays) ray = aimedRay(target.mesh, target.place, random);
        const bool any = round % 3 == 2;
        any ? accel.anyHits(rays, occluded) : accel.closestHits(rays, hits);
        for (std::size_t i = 0; i < kBatch; ++i)
            if (any ? !occluded[i] : hits[i].primitive == kNoPrimitive) {
                ADD_FAILURE() << "leak after " << shot + i << " rays: " << target.mesh.name << " at 2^"
                              << target.place.exponent << ", isa " << static_cast<int>(accel.summary().isa)
                              << ": " << text(rays[i]);
                return shot;
            }
        shot += kBatch;
    }
    return shot;
}

std::uint64_t traceSpawnedRays(std::uint64_t count) {
    Random random(29);
    struct Target {
        TestGeometry mesh;
        std::shared_ptr<const trace::World> world;
        bool closed;
        double size;
    };
    std::vector<Target> targets;
    for (const Place& place : places(1e3)) {
        for (const TestGeometry& unit : {icosphere(2, 0.0, 1), gridBox(4)}) {
            const TestGeometry mesh = placed(unit, place);
            if (isConvex(mesh))
                targets.push_back({mesh, worldOf(mesh), true, std::ldexp(1.0, place.exponent)});
        }
    }
    EXPECT_GE(targets.size(), 8u);
    for (const Place& place : places(1e6)) {
        const TestGeometry mesh = placed(tiltedPlane(), place);
        targets.push_back({mesh, worldOf(mesh), false, std::ldexp(8.0, place.exponent)});
    }
    std::uint64_t left = 0;
    for (std::size_t round = 0; left < count; ++round) {
        const Target& target = targets[round % targets.size()];
        for (std::size_t i = 0; i < kBatch / 2; ++i) {
            left += traceSpawnedRay(*target.world, target.mesh, target.closed, target.size, random) ? 2 : 0;
            if (testing::Test::HasFailure()) return left;
        }
    }
    return left;
}

}  // namespace rayscope::test
