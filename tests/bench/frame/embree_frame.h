#pragma once
// A small renderer around Embree, for comparison: one ray at a time, scalar Phong shading in float, a hash as
// the sampler; point lights, hard shadows, mirrors.
#include <embree3/rtcore.h>

#include <cstdint>
#include <span>
#include <vector>

#include "trace/world.h"

namespace rayscope::bench {

class EmbreeFrame {
  public:
    /// The world must have point lights and triangles at rest only, without textures, and outlive this
    /// object.
    EmbreeFrame(const trace::World& world, const CameraDescription& camera);
    ~EmbreeFrame();
    EmbreeFrame(const EmbreeFrame&) = delete;
    EmbreeFrame& operator=(const EmbreeFrame&) = delete;

    /// The mean of `samples` samples of each pixel. Returns the number of rays.
    std::uint64_t render(int samples, std::span<glm::vec3> image) const;

  private:
    struct Surface {
        glm::vec3 position, normal;
        std::uint32_t material;
    };
    struct Material {
        glm::vec3 kd, ks;
        float shininess;
        bool reflects;
    };
    bool intersect(const glm::vec3& origin, const glm::vec3& direction, Surface& surface) const;
    bool isOccluded(const glm::vec3& origin, const glm::vec3& toLight) const;
    glm::vec3 radiance(glm::vec3 origin, glm::vec3 direction, std::uint64_t& rays) const;

    const trace::World& world_;
    glm::vec3 eye_, forward_, right_, up_;
    float epsilon_;
    std::vector<Material> materials_;
    std::vector<std::uint32_t> materialOf_;  ///< per triangle
    std::vector<glm::vec3> normals_;         ///< three per triangle, unit
    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace rayscope::bench
