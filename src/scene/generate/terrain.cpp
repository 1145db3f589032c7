#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/memory_budget.h"
#include "scene/generate/generate.h"
#include "scene/load_step.h"

namespace rayscope::scene {

namespace {

/// A pseudo-random number in [0, 1) for each point of the integer grid.
double hashAt(std::int64_t x, std::int64_t z, std::int64_t seed) {
    auto h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull ^
             static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4full ^
             static_cast<std::uint64_t>(seed) * 0x165667b19e3779f9ull;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// Value and gradient of a height field: {value, d/dx, d/dz}.
using Slope = glm::dvec3;

/// Value noise with quintic interpolation, so that its second derivative is continuous.
Slope noiseAt(double x, double z, std::int64_t seed) {
    const auto fade = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
    const auto fadeSlope = [](double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); };
    const double floorX = std::floor(x), floorZ = std::floor(z);
    const auto i = static_cast<std::int64_t>(floorX), k = static_cast<std::int64_t>(floorZ);
    const double u = fade(x - floorX), v = fade(z - floorZ);
    const double a = hashAt(i, k, seed), b = hashAt(i + 1, k, seed);
    const double c = hashAt(i, k + 1, seed), d = hashAt(i + 1, k + 1, seed);
    const double mixed = a - b - c + d;
    return {a + (b - a) * u + (c - a) * v + mixed * u * v, (b - a + mixed * v) * fadeSlope(x - floorX),
            (c - a + mixed * u) * fadeSlope(z - floorZ)};
}

/// Eight octaves of noise, squared for flat valleys and pointed summits; values in [0, 1).
Slope heightAt(double x, double z, std::int64_t seed) {
    constexpr int kOctaves = 8;
    Slope sum(0.0);
    double frequency = 3.0, amplitude = 0.5, total = 0.0;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const Slope noise = noiseAt(x * frequency, z * frequency, seed + octave);
        sum += amplitude * Slope(noise.x, noise.y * frequency, noise.z * frequency);
        total += amplitude;
        frequency *= 2.03;  // not 2, so that the grid lines of the octaves do not coincide
        amplitude *= 0.46;
    }
    sum /= total;
    return {sum.x * sum.x, 2.0 * sum.x * sum.y, 2.0 * sum.x * sum.z};
}

/// Calls visit(row) for all rows, in parallel within groups of rows; progress counts from `done`.
template <class Visit>
void forEachRow(std::size_t rows, LoadStep& step, std::size_t done, const Visit& visit) {
    constexpr std::size_t kGroup = 64;
    for (std::size_t first = 0; first < rows; first += kGroup) {
        step.advanceTo(done + first);
        tbb::parallel_for(first, std::min(first + kGroup, rows), visit);
    }
}

}  // namespace

MeshData generate(const TerrainShape& shape, const LoadControl& control) {
    const auto columns = static_cast<std::size_t>(shape.cellsX),
               rows = static_cast<std::size_t>(shape.cellsZ);
    const glm::dvec2 size(shape.size);
    const auto height = static_cast<double>(shape.height);
    LoadStep step(control, "generating a terrain", 2 * rows);
    MeshData mesh;
    base::requireMemory(
        (columns + 1) * (rows + 1) * 2 * sizeof(glm::vec3) + 2 * columns * rows * sizeof(glm::uvec3),
        "fewer cells", "a terrain of {} x {} cells", columns, rows);
    mesh.positions.resize((columns + 1) * (rows + 1));
    mesh.normals.resize(mesh.positions.size());
    mesh.triangles.resize(2 * columns * rows);
    forEachRow(rows + 1, step, 0, [&](std::size_t k) {
        for (std::size_t i = 0; i <= columns; ++i) {
            // Noise coordinates in units of the longer side, for isotropic noise.
            const double x = size.x * (static_cast<double>(i) / static_cast<double>(columns) - 0.5);
            const double z = size.y * (static_cast<double>(k) / static_cast<double>(rows) - 0.5);
            const double unit = std::max(size.x, size.y);
            const Slope slope = heightAt(x / unit, z / unit, shape.seed);
            const std::size_t at = k * (columns + 1) + i;
            mesh.positions[at] = glm::dvec3(x, height * slope.x, z);
            mesh.normals[at] =
                glm::normalize(glm::dvec3(-height * slope.y / unit, 1.0, -height * slope.z / unit));
        }
    });
    forEachRow(rows, step, rows, [&](std::size_t k) {
        for (std::size_t i = 0; i < columns; ++i) {
            const auto a = static_cast<std::uint32_t>(k * (columns + 1) + i), b = a + 1;
            const auto c = static_cast<std::uint32_t>(a + columns + 1), d = c + 1;
            mesh.triangles[2 * (k * columns + i)] = {a, c, b};
            mesh.triangles[2 * (k * columns + i) + 1] = {b, c, d};
        }
    });
    return mesh;
}

}  // namespace rayscope::scene
