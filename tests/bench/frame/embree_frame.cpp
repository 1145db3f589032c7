#include "bench/frame/embree_frame.h"

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace rayscope::bench {
namespace {

std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
float uniform(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

template <class T>
void copyBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::span<const T> items) {
    std::memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size()), items.data(),
                items.size_bytes());
}

}  // namespace

EmbreeFrame::EmbreeFrame(const trace::World& world, const CameraDescription& camera)
    : world_(world), eye_(camera.lookFrom), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    const float half = std::tan(camera.fov * std::numbers::pi_v<float> / 360.0f);
    forward_ = glm::normalize(camera.lookAt - camera.lookFrom);
    right_ = glm::normalize(glm::cross(forward_, camera.up));
    up_ = half * glm::cross(right_, forward_);
    right_ *= half * static_cast<float>(world.width) / static_cast<float>(world.height);
    for (const trace::SurfaceMaterial& m : world.materials)
        materials_.push_back({glm::vec3(m.kd), glm::vec3(m.ks), static_cast<float>(m.shininess), m.reflects});
    const AccelInput& input = world.motionGroups.at(0).geometry->input;
    glm::vec3 size(0.0f);
    for (const glm::vec3& v : input.vertices) size = glm::max(size, glm::abs(v));
    epsilon_ = 1e-5f * std::max(size.x, std::max(size.y, size.z));
    for (std::uint32_t i = 0; i < input.triangles.size(); ++i) {
        const trace::PrimitiveLocation location = world.locatePrimitive(i);
        materialOf_.push_back(world.materialOf(location));
        const glm::uvec3 t = input.triangles[i];
        const glm::vec3 a = input.vertices[t.x], b = input.vertices[t.y], c = input.vertices[t.z];
        const glm::vec3 flat = glm::normalize(glm::cross(b - a, c - a));
        const auto& given = location.range->mesh->normals;
        const glm::uvec3 corner = location.range->mesh->triangles[location.inObject];
        for (const std::uint32_t k : {corner.x, corner.y, corner.z})
            normals_.push_back(given.empty() ? flat
                                             : glm::normalize(glm::vec3(location.range->normalMatrix *
                                                                        glm::dvec3(given[k]))));
    }
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    copyBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, input.vertices);
    copyBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, input.triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
}

EmbreeFrame::~EmbreeFrame() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

bool EmbreeFrame::intersect(const glm::vec3& o, const glm::vec3& d, Surface& surface) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = {o.x, o.y, o.z, 0.0f, d.x, d.y, d.z, 0.0f, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const float u = query.hit.u, v = query.hit.v;
    const glm::vec3* const n = &normals_[3 * std::size_t{query.hit.primID}];
    surface.position = o + query.ray.tfar * d;
    surface.normal = glm::normalize((1.0f - u - v) * n[0] + u * n[1] + v * n[2]);
    if (glm::dot(surface.normal, d) > 0.0f) surface.normal = -surface.normal;
    surface.material = materialOf_[query.hit.primID];
    return true;
}

bool EmbreeFrame::isOccluded(const glm::vec3& o, const glm::vec3& d) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{o.x, o.y, o.z, 0.0f, d.x, d.y, d.z, 0.0f, 1.0f, ~0u, 0, 0};
    rtcOccluded1(scene_, &context, &ray);
    return ray.tfar < 0.0f;
}

glm::vec3 EmbreeFrame::radiance(glm::vec3 origin, glm::vec3 direction, std::uint64_t& rays) const {
    glm::vec3 sum(0.0f), throughput(1.0f);
    Surface at;
    for (int depth = 0;; ++depth) {
        ++rays;
        if (!intersect(origin, direction, at)) return sum;
        const Material& material = materials_[at.material];
        const glm::vec3 from = at.position + epsilon_ * at.normal;
        const glm::vec3 mirrored = direction - 2.0f * glm::dot(direction, at.normal) * at.normal;
        for (const trace::CompiledLight& light : world_.lights) {
            const auto& point = std::get<PointLight>(light.light.shape);
            const glm::vec3 toLight = point.position - from;
            const glm::vec3 l = glm::normalize(toLight);
            const float cosine = glm::dot(at.normal, l);
            if (cosine <= 0.0f || (++rays, isOccluded(from, toLight))) continue;
            const float highlight = std::pow(std::max(0.0f, glm::dot(mirrored, l)), material.shininess);
            sum += throughput * glm::vec3(point.color) * (material.kd * cosine + material.ks * highlight);
        }
        if (!material.reflects || depth >= world_.settings.maxDepth) return sum;
        throughput *= material.ks;
        origin = from;
        direction = mirrored;
    }
}

std::uint64_t EmbreeFrame::render(int samples, std::span<glm::vec3> image) const {
    const int width = world_.width, height = world_.height;
    std::atomic<std::uint64_t> total{0};
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range2d<int>(0, height, 16, 0, width, 16), [&](const auto& tile) {
            std::uint64_t rays = 0;
            for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
                for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                    const auto pixel = static_cast<std::uint32_t>(y * width + x);
                    glm::vec3 sum(0.0f);
                    for (int k = 0; k < samples; ++k) {
                        const std::uint32_t a = hash(pixel + 0x9e3779b9u * static_cast<std::uint32_t>(k + 1));
                        const float px = static_cast<float>(x) + uniform(a);
                        const float py = static_cast<float>(y) + uniform(hash(a));
                        sum +=
                            radiance(eye_,
                                     glm::normalize(forward_ +
                                                    (2.0f * px / static_cast<float>(width) - 1.0f) * right_ +
                                                    (1.0f - 2.0f * py / static_cast<float>(height)) * up_),
                                     rays);
                    }
                    image[pixel] = sum / static_cast<float>(samples);
                }
            total += rays;
        });
    return total;
}

}  // namespace rayscope::bench
