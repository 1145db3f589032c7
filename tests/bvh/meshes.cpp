#include "bvh/meshes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "support/non_finite.h"

namespace rayscope::test {
namespace {

TestGeometry octahedron() {
    return {"octahedron",
            {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
            {}};
}

TestGeometry subdivided(const TestGeometry& coarse) {
    TestGeometry fine{coarse.name, coarse.vertices, {}, {}};
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
        const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), fine.vertices.size());
        if (isNew) fine.vertices.push_back(glm::normalize(fine.vertices[a] + fine.vertices[b]));
        return entry->second;
    };
    for (const glm::uvec3& t : coarse.triangles) {
        const unsigned ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
        for (const glm::uvec3& part : {glm::uvec3{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}})
            fine.triangles.push_back(part);
    }
    return fine;
}

TestGeometry named(std::string name, TestGeometry geometry) {
    geometry.name = std::move(name);
    return geometry;
}

TestGeometry withSpheres(TestGeometry geometry, int count, std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < count; ++i)
        geometry.spheres.push_back({random.inCube(), static_cast<float>(random.real(0.01, 0.3))});
    return geometry;
}

TestGeometry notFinite() {
    TestGeometry geometry = soup(40, 0.4, 11);
    geometry.vertices[3].y = kNaN;
    geometry.vertices[31].x = kInfinity;
    geometry.vertices[62].z = -kInfinity;
    geometry.spheres = {{{0, 0, 0}, kNaN},     {{kNaN, 0, 0}, 1.0f},        {{0, 0, 0}, -1.0f},
                        {{0, 0, 0}, 0.0f},     {{0.2f, 0.1f, 0.3f}, 0.25f}, {{0, 0, 0}, kInfinity},
                        {{3e38f, 0, 0}, 3e38f}};
    return named("not finite", geometry);
}

TestGeometry degenerate() {
    Random random(5);
    TestGeometry geometry;
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 a = random.inCube(), b = random.inCube();
        geometry.addTriangle(a, b, b);
        geometry.addTriangle(a, b, 0.5f * (a + b));
        geometry.addTriangle(a, a, a);
        geometry.addTriangle(a, b, random.inCube());
    }
    return named("zero area", geometry);
}

TestGeometry repeated(int copies) {
    TestGeometry geometry = octahedron();
    const std::vector<glm::uvec3> once = geometry.triangles;
    for (int i = 1; i < copies; ++i)
        geometry.triangles.insert(geometry.triangles.end(), once.begin(), once.end());
    return named("duplicates", geometry);
}

TestGeometry equalCentroids() {
    TestGeometry geometry;
    for (int i = 1; i <= 300; ++i) {
        const float r = static_cast<float>(i) / 300.0f;
        geometry.addTriangle({-r, -r, -r}, {r, r, r}, {r, -r, r});
    }
    return named("equal centroids", geometry);
}

/// Each triangle has a thousandth of the size and distance of the one before, which makes greedy trees
/// degenerate.
TestGeometry geometricSeries() {
    TestGeometry geometry;
    for (int i = -12; i <= 12; ++i) {
        const float s = std::pow(1000.0f, static_cast<float>(i));
        geometry.addTriangle({s, 0, 0}, {s, s, 0}, {s, 0, s});
    }
    return named("geometric series", geometry);
}

TestGeometry flatGrid() {
    TestGeometry geometry;
    for (int x = -4; x < 4; ++x)
        for (int y = -4; y < 4; ++y) {
            const glm::vec3 a(x, y, 0), b(x + 1, y, 0), c(x + 1, y + 1, 0), d(x, y + 1, 0);
            geometry.addTriangle(0.25f * a, 0.25f * b, 0.25f * c);
            geometry.addTriangle(0.25f * a, 0.25f * c, 0.25f * d);
        }
    return named("flat grid", geometry);
}

}  // namespace

glm::dvec3 Random::onSphere() {
    const double z = real(-1, 1), phi = real(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

void TestGeometry::addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<unsigned>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.emplace_back(first, first + 1, first + 2);
}

TestGeometry TestGeometry::transformed(double scale, const glm::dvec3& offset) const {
    TestGeometry result = *this;
    for (glm::vec3& v : result.vertices) v = glm::vec3(glm::dvec3(v) * scale + offset);
    for (Sphere& s : result.spheres)
        s = {glm::vec3(glm::dvec3(s.center) * scale + offset), static_cast<float>(s.radius * scale)};
    return result;
}

TestGeometry icosphere(int subdivisions, double jitter, std::uint64_t seed) {
    TestGeometry geometry = octahedron();
    for (int i = 0; i < subdivisions; ++i) geometry = subdivided(geometry);
    Random random(seed);
    for (glm::vec3& v : geometry.vertices) v *= static_cast<float>(1.0 + random.real(-jitter, jitter));
    return named("icosphere", geometry);
}

TestGeometry needleSphere(int rings, int segments) {
    TestGeometry geometry{"needles", {{0, 0, 1}}, {}, {}};
    const auto at = [&](int ring, int segment) {
        return static_cast<unsigned>(1 + (ring - 1) * segments + segment % segments);
    };
    for (int ring = 1; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const double theta = std::numbers::pi * ring / rings,
                         phi = 2 * std::numbers::pi * segment / segments;
            geometry.vertices.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                           std::cos(theta));
        }
    const auto south = static_cast<unsigned>(geometry.vertices.size());
    geometry.vertices.emplace_back(0, 0, -1);
    for (int segment = 0; segment < segments; ++segment) {
        geometry.triangles.emplace_back(0u, at(1, segment), at(1, segment + 1));
        for (int ring = 1; ring < rings - 1; ++ring) {
            geometry.triangles.emplace_back(at(ring, segment), at(ring + 1, segment),
                                            at(ring + 1, segment + 1));
            geometry.triangles.emplace_back(at(ring, segment), at(ring + 1, segment + 1),
                                            at(ring, segment + 1));
        }
        geometry.triangles.emplace_back(at(rings - 1, segment), south, at(rings - 1, segment + 1));
    }
    return geometry;
}

TestGeometry gridBox(int cells) {
    TestGeometry geometry{"grid box", {}, {}, {}};
    std::map<std::tuple<float, float, float>, unsigned> known;
    const auto vertex = [&](glm::vec3 p) {
        const auto [entry, isNew] = known.try_emplace({p.x, p.y, p.z}, geometry.vertices.size());
        if (isNew) geometry.vertices.push_back(p);
        return entry->second;
    };
    const float step = 2.0f / static_cast<float>(cells);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const auto at = [&](int u, int v) {
                        glm::vec3 p;
                        p[axis] = side ? 1.0f : -1.0f;
                        p[(axis + 1) % 3] = -1.0f + step * static_cast<float>(u);
                        p[(axis + 2) % 3] = -1.0f + step * static_cast<float>(v);
                        return vertex(p);
                    };
                    const unsigned a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                    geometry.triangles.emplace_back(side ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b));
                    geometry.triangles.emplace_back(side ? glm::uvec3(a, c, d) : glm::uvec3(a, d, c));
                }
    return geometry;
}

TestGeometry soup(int triangles, double size, std::uint64_t seed) {
    Random random(seed);
    TestGeometry geometry{"soup", {}, {}, {}};
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 at = random.inCube();
        geometry.addTriangle(at, at + random.inCube(size), at + random.inCube(size));
    }
    return geometry;
}

std::vector<TestGeometry> edgeCaseScenes() {
    std::vector<TestGeometry> scenes;
    scenes.push_back(named("one triangle", soup(1, 1.0, 3)));
    scenes.push_back(named("two triangles", soup(2, 1.0, 4)));
    scenes.push_back(named("one sphere", withSpheres({}, 1, 4)));
    scenes.push_back(named("soup and spheres", withSpheres(soup(300, 0.3, 1), 40, 2)));
    scenes.push_back(named("long triangles", soup(200, 2.0, 8)));
    scenes.push_back(notFinite());
    scenes.push_back(degenerate());
    scenes.push_back(repeated(20));
    scenes.push_back(equalCentroids());
    scenes.push_back(geometricSeries());
    scenes.push_back(flatGrid());
    scenes.push_back(icosphere(3, 0.05, 6));
    scenes.push_back(needleSphere(4, 64));
    scenes.push_back(gridBox(4));
    const TestGeometry mixed = withSpheres(soup(150, 0.4, 21), 20, 22);
    for (const double scale : {0x1p-60, 0x1p-30, 0x1p30, 0x1p60})
        scenes.push_back(named(fmt::format("scale {:g}", scale), mixed.transformed(scale, {})));
    scenes.push_back(named("far away", mixed.transformed(1.0, {1e6, -1e6, 1e6})));
    scenes.push_back(named("small and far away", mixed.transformed(1e-3, {1e3, 1e3, -1e3})));
    return scenes;
}

std::vector<Ray> edgeCaseRays(const TestGeometry& geometry, int count, std::uint64_t seed) {
    Random random(seed);
    glm::dvec3 lower(1e300), upper(-1e300);
    const auto cover = [&](const glm::dvec3& p) {
        if (!(glm::dot(p, p) < 1e300)) return;
        lower = glm::min(lower, p), upper = glm::max(upper, p);
    };
    for (const glm::vec3& v : geometry.vertices) cover(v);
    for (const Sphere& s : geometry.spheres) cover(s.center);
    const glm::dvec3 center = 0.5 * (lower + upper);
    const double radius = std::max(glm::length(upper - lower), 1e-30);

    const auto somePoint = [&]() -> glm::dvec3 {
        if (geometry.triangles.empty()) return center + radius * glm::dvec3(random.inCube());
        const auto t = static_cast<std::size_t>(random.integer(static_cast<int>(geometry.triangles.size())));
        const glm::dvec3 a = geometry.corner(t, 0), b = geometry.corner(t, 1), c = geometry.corner(t, 2);
        switch (random.integer(4)) {
            case 0:
                return a;
            case 1:
                return 0.5 * (a + b);
            case 2:
                return (a + b + c) / 3.0;
            default:
                return a + random.real() * (c - a);
        }
    };
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count) {
        Ray ray;
        const glm::dvec3 target = somePoint();
        switch (random.integer(5)) {
            case 0:  // axis-parallel through a point of the geometry, with zeros of both signs
            {
                const int axis = random.integer(3);
                const float sign = random.integer(2) ? 1.0f : -1.0f;
                ray.direction = glm::vec3(random.integer(2) ? 0.0f : -0.0f);
                ray.direction[axis] = sign;
                ray.origin = glm::vec3(target);
                ray.origin[axis] = static_cast<float>(target[axis] - sign * radius * random.real(0, 2));
                break;
            }
            case 1:  // in a plane through the geometry
                ray.origin = glm::vec3(center + radius * random.onSphere());
                ray.direction = glm::vec3(random.onSphere());
                ray.origin[1] = static_cast<float>(target[1]);
                ray.direction[1] = random.integer(2) ? 0.0f : -0.0f;
                break;
            case 2:  // from somewhere inside
                ray.origin = glm::vec3(target);
                ray.direction = glm::vec3(random.onSphere());
                break;
            default: {  // aimed at a point of the geometry, with a direction of any length
                const glm::vec3 origin(center + radius * random.real(0, 3) * random.onSphere());
                const double length = random.integer(2) ? 1.0 / radius : std::exp2(random.integer(41) - 20);
                ray.origin = origin;
                ray.direction = glm::vec3((target - glm::dvec3(origin)) * length);
            }
        }
        if (random.integer(4) == 0) {
            const double unit = radius / std::max(glm::length(glm::dvec3(ray.direction)), 1e-30);
            ray.tMin = static_cast<float>(random.real(0, 0.5) * unit);
            ray.tMax = static_cast<float>(ray.tMin + random.real(0, 1.5) * unit);
        }
        rays.push_back(ray);
    }
    return rays;
}

bool sameHit(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

std::string text(const Ray& ray) {
    return fmt::format("origin {:a} {:a} {:a} direction {:a} {:a} {:a} t {:a} … {:a}", ray.origin.x,
                       ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                       ray.tMin, ray.tMax);
}

std::string text(const Hit& hit) {
    return fmt::format("t {:a} primitive {} u {:a} v {:a}", hit.t, hit.primitive, hit.u, hit.v);
}

}  // namespace rayscope::test
