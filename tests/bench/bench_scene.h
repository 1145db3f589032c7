#pragma once
// The mesh of the benchmarks: a bumpy sphere with any number of triangles.
#include <rayscope/accel.h>
#include <vector>

namespace rayscope::bench {

struct BumpySphere {
    explicit BumpySphere(int triangles);
    AccelInput input() const { return {vertices, triangles, {}}; }

    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

}  // namespace rayscope::bench
