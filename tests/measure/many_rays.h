#pragma once
// Tests with very many rays; every test run executes them with fewer.
#include <cstdint>

namespace rayscope::test {

// Meshes, adjacency and ray generators are those of the robustness test (src/measure/lab). The expected
// results are independent of it: they follow from topology and convexity, not from exact arithmetic on single
// triangles, and the queries are batched and use every kernel.

/// Traces about `count` rays from inside closed meshes to shared edges and vertices: icosphere, displaced
/// vertices, needles, and a box with a dyadic grid, whose edges are hit exactly; scales 2^-60 … 2^60, offsets
/// up to 10^6 sizes; all kernels, closest-hit and any-hit queries, in batches. Every ray must hit. Fails at
/// the first leak. Returns the number of rays.
std::uint64_t traceRaysAtSharedEdges(std::uint64_t count);

/// Traces about `count` spawned rays from convex and plane meshes at angles down to 1e-4, on both sides.
/// Outward none may hit, inward all must. Returns the number of rays.
std::uint64_t traceSpawnedRays(std::uint64_t count);

}  // namespace rayscope::test
