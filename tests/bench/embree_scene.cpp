#include "bench/embree_scene.h"

#include <cstring>

namespace rayscope::bench {

EmbreeScene::EmbreeScene(const BumpySphere& mesh, bool robust)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        sizeof(glm::vec3), mesh.vertices.size()),
                mesh.vertices.data(), mesh.vertices.size() * sizeof(glm::vec3));
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                        sizeof(glm::uvec3), mesh.triangles.size()),
                mesh.triangles.data(), mesh.triangles.size() * sizeof(glm::uvec3));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void EmbreeScene::trace(const std::vector<Ray>& rays, bool any) const {
    RTCIntersectContext context;
    for (const Ray& ray : rays) {
        rtcInitIntersectContext(&context);
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
        if (any) {
            rtcOccluded1(scene_, &context, &query.ray);
        } else {
            rtcIntersect1(scene_, &context, &query);
        }
    }
}

}  // namespace rayscope::bench
