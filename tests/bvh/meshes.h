#pragma once
// Geometry and rays for the tests of module bvh, determined by seeds.
#include <rayscope/accel.h>
#include <functional>
#include <string>
#include <vector>

namespace rayscope::test {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double real() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1)
    double real(double low, double high) { return low + (high - low) * real(); }
    int integer(int count) { return static_cast<int>(real() * count); }  ///< 0 … count − 1
    glm::vec3 inCube(double half = 1.0) {
        return {static_cast<float>(real(-half, half)), static_cast<float>(real(-half, half)),
                static_cast<float>(real(-half, half))};
    }
    glm::dvec3 onSphere();

  private:
    std::uint64_t state_;
};

/// Owns the data of an AccelInput.
struct TestGeometry {
    std::string name;
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    std::vector<Sphere> spheres;

    AccelInput input() const { return {vertices, triangles, spheres}; }
    void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
    glm::vec3 corner(std::size_t triangle, int k) const { return vertices[triangles[triangle][k]]; }
    TestGeometry transformed(double scale, const glm::dvec3& offset) const;
};

/// Closed meshes around the origin, star-shaped as seen from there.
TestGeometry icosphere(int subdivisions, double jitter, std::uint64_t seed);
TestGeometry needleSphere(int rings, int segments);
TestGeometry gridBox(int cells);  ///< vertices on a dyadic grid, so that rays hit edges exactly

/// Small triangles scattered in the unit cube.
TestGeometry soup(int triangles, double size, std::uint64_t seed);

/// Difficult scenes for builders and traversals: degenerate, coincident, extreme, with spheres.
std::vector<TestGeometry> edgeCaseScenes();

/// Rays around a scene of about `radius` at `center`: random, axis-parallel with ±0, aimed at vertices and
/// edges, inside box planes, with small and large directions and bounded intervals.
std::vector<Ray> edgeCaseRays(const TestGeometry& geometry, int count, std::uint64_t seed);

bool sameHit(const Hit& a, const Hit& b);  ///< bit for bit
std::string text(const Ray& ray);
std::string text(const Hit& hit);

}  // namespace rayscope::test
