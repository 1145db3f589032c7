// Embree in its robust mode finds the same hits on closed meshes at the same distance.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

class EmbreeScene {
  public:
    explicit EmbreeScene(const TestGeometry& mesh)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(glm::vec3), mesh.vertices.size());
        std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(glm::vec3));
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(glm::uvec3), mesh.triangles.size());
        std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(glm::uvec3));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Infinity on a miss.
    float distance(const Ray& ray) const {
        RTCRayHit query{};
        query.ray = {ray.origin.x,
                     ray.origin.y,
                     ray.origin.z,
                     ray.tMin,
                     ray.direction.x,
                     ray.direction.y,
                     ray.direction.z,
                     0.0f,
                     ray.tMax,
                     ~0u,
                     0,
                     0};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity()
                                                           : query.ray.tfar;
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

TEST(Embree, FindsTheSameSurface) {
    for (const TestGeometry& mesh :
         {icosphere(4, 0.1, 2), icosphere(2, 0.3, 4), needleSphere(16, 64), gridBox(8)}) {
        const EmbreeScene embree(mesh);
        const Accel accel = Accel::build(mesh.input());
        Random random(3);
        for (int i = 0; i < 30000; ++i) {
            Ray ray;
            const bool fromInside = random.integer(2);
            ray.origin = fromInside ? 0.3f * random.inCube() : glm::vec3(3.0 * random.onSphere());
            ray.direction =
                glm::vec3(glm::dvec3(random.inCube()) * (fromInside ? 1.0 : 0.4) - glm::dvec3(ray.origin));
            Hit hit;
            accel.closestHit(ray, hit);
            const float other = embree.distance(ray);
            ASSERT_EQ(hit.t < std::numeric_limits<float>::infinity(),
                      other < std::numeric_limits<float>::infinity())
                << mesh.name << " " << text(ray);
            if (std::isinf(other)) continue;
            // The robust mode computes in float: grazing faces lose the digits that the slope takes.
            const glm::dvec3 a = mesh.corner(hit.primitive, 0), b = mesh.corner(hit.primitive, 1),
                             c = mesh.corner(hit.primitive, 2);
            const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
            const double slope = 1.0 / std::abs(glm::dot(normal, glm::normalize(glm::dvec3(ray.direction))));
            ASSERT_NEAR(hit.t, other, 0x1p-18 * slope * hit.t) << mesh.name << " " << text(ray);
        }
    }
}

}  // namespace
}  // namespace rayscope::test
