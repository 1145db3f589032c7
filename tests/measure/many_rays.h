#pragma once
// Experiments that only very many rays can settle; the same code runs with few of them in every test run.
#include <cstdint>

namespace rayscope::test {

/// Shoots about `count` rays from inside closed meshes at shared edges and vertices: icosphere, moved
/// vertices, needles, and a box whose grid is met exactly; scales 2^-60 … 2^60, offsets up to 10^6 sizes;
/// every kernel in turn, closest and any, in batches. Fails at the first ray that leaks. Returns the number
/// of rays.
std::uint64_t traceRaysAtSharedEdges(std::uint64_t count);

/// Lets about `count` rays leave convex and plane meshes at angles down to 1e-4, on both sides. Outward none
/// hits anything, inward all do. Returns the number of rays.
std::uint64_t traceSpawnedRays(std::uint64_t count);

}  // namespace rayscope::test
