#include "measure/bench/embree_baseline.h"
#include "base/memory_budget.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>

#include "base/memory_budget.h"

namespace rayscope::measure {
namespace {

constexpr std::size_t kStreamLength = 16384;

template <class T>
void setBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::span<const T> items) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
    if (!buffer && !items.empty()) throw std::bad_alloc();
    if (!items.empty()) std::memcpy(buffer, items.data(), items.size_bytes());
}

/// Embree ends the program if a thread of TBB, which it uses, too, cannot be started; here it is an
/// exception.
void startWorkers(int threads) {
    oneapi::tbb::task_arena arena(threads > 0 ? threads : oneapi::tbb::task_arena::automatic);
    arena.execute([&] { oneapi::tbb::parallel_for(0, 4 * arena.max_concurrency(), [](int) {}); });
}

/// Throws what Embree reports as an error: that of the device, or without one that of its creation. A lack of
/// memory in a worker of TBB is an unknown error to Embree, and nothing else is known to cause one.
void throwOnError(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY || error == RTC_ERROR_UNKNOWN)
        base::throwOutOfMemoryWhile("Embree works, or an error that it does not name", "a smaller scene");
    if (error != RTC_ERROR_NONE || !device)
        throw std::runtime_error(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

RTCRayHit queryOf(const Ray& ray) {
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.tnear = ray.tMin;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tfar = ray.tMax;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return query;
}

template <class Packet>
void setLane(Packet& packet, std::size_t lane, const Ray& ray) {
    packet.org_x[lane] = ray.origin.x;
    packet.org_y[lane] = ray.origin.y;
    packet.org_z[lane] = ray.origin.z;
    packet.tnear[lane] = ray.tMin;
    packet.dir_x[lane] = ray.direction.x;
    packet.dir_y[lane] = ray.direction.y;
    packet.dir_z[lane] = ray.direction.z;
    packet.tfar[lane] = ray.tMax;
    packet.time[lane] = 0.0f;
    packet.mask[lane] = ~0u;
    packet.flags[lane] = 0;
}

}  // namespace

struct EmbreeBaseline::State {
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<long> bytes = 0;
    double buildSeconds = 0.0;
    std::uint32_t triangles = 0;

    Hit hitOf(float t, unsigned geometry, unsigned primitive, float u, float v) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
        return geometry == 0 ? Hit{t, primitive, u, v} : Hit{t, triangles + primitive, 0.0f, 0.0f};
    }
    RTCIntersectContext context(bool coherent) const {
        RTCIntersectContext made;
        rtcInitIntersectContext(&made);
        if (coherent) made.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        return made;
    }
};

bool EmbreeBaseline::isAvailable() { return true; }

EmbreeBaseline::EmbreeBaseline(const AccelInput& input, bool robust, int threads)
    : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.triangles = static_cast<std::uint32_t>(input.triangles.size());
    startWorkers(threads);
    s.device = rtcNewDevice(threads > 0 ? fmt::format("threads={}", threads).c_str() : nullptr);
    throwOnError(s.device);
    rtcSetDeviceMemoryMonitorFunction(
        s.device,
        [](void* counter, ssize_t bytes, bool) {
            *static_cast<std::atomic<long>*>(counter) += bytes;
            return true;
        },
        &s.bytes);
    s.scene = rtcNewScene(s.device);
    throwOnError(s.device);
    rtcSetSceneBuildQuality(s.scene, RTC_BUILD_QUALITY_MEDIUM);
    if (robust) rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    setBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, input.vertices);
    setBuffer(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, input.triangles);
    rtcCommitGeometry(mesh);
    rtcAttachGeometryByID(s.scene, mesh, 0);
    rtcReleaseGeometry(mesh);
    if (!input.spheres.empty()) {
        RTCGeometry spheres = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        setBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, input.spheres);
        rtcCommitGeometry(spheres);
        rtcAttachGeometryByID(s.scene, spheres, 1);
        rtcReleaseGeometry(spheres);
    }
    throwOnError(s.device);
    const long before = s.bytes;
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(s.scene);
    throwOnError(s.device);
    s.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    s.bytes -= before;
}

EmbreeBaseline::~EmbreeBaseline() = default;

double EmbreeBaseline::buildSeconds() const { return state_->buildSeconds; }
std::size_t EmbreeBaseline::bytes() const { return static_cast<std::size_t>(state_->bytes.load()); }

void EmbreeBaseline::closestHits(EmbreeQuery query, bool coherent, std::span<const Ray> rays,
                                 std::span<Hit> hits) const {
    const State& s = *state_;
    RTCIntersectContext context = s.context(coherent);
    if (query == EmbreeQuery::Single) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit one = queryOf(rays[i]);
            rtcIntersect1(s.scene, &context, &one);
            hits[i] = s.hitOf(one.ray.tfar, one.hit.geomID, one.hit.primID, one.hit.u, one.hit.v);
        }
    } else if (query == EmbreeQuery::Packet16) {
        for (std::size_t i = 0; i < rays.size(); i += 16) {
            alignas(64) RTCRayHit16 packet;
            alignas(64) int valid[16];
            for (std::size_t lane = 0; lane < 16; ++lane) {
                valid[lane] = i + lane < rays.size() ? -1 : 0;
                setLane(packet.ray, lane, rays[std::min(i + lane, rays.size() - 1)]);
                packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
                packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, s.scene, &context, &packet);
            for (std::size_t lane = 0; lane < std::min<std::size_t>(16, rays.size() - i); ++lane)
                hits[i + lane] = s.hitOf(packet.ray.tfar[lane], packet.hit.geomID[lane],
                                         packet.hit.primID[lane], packet.hit.u[lane], packet.hit.v[lane]);
        }
    } else {
        std::vector<RTCRayHit> stream(std::min(kStreamLength, rays.size()));
        for (std::size_t i = 0; i < rays.size(); i += kStreamLength) {
            const std::size_t count = std::min(kStreamLength, rays.size() - i);
            for (std::size_t k = 0; k < count; ++k) stream[k] = queryOf(rays[i + k]);
            rtcIntersect1M(s.scene, &context, stream.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
            for (std::size_t k = 0; k < count; ++k)
                hits[i + k] = s.hitOf(stream[k].ray.tfar, stream[k].hit.geomID, stream[k].hit.primID,
                                      stream[k].hit.u, stream[k].hit.v);
        }
    }
}

void EmbreeBaseline::anyHits(EmbreeQuery query, bool coherent, std::span<const Ray> rays,
                             std::span<std::uint8_t> occluded) const {
    const State& s = *state_;
    RTCIntersectContext context = s.context(coherent);
    if (query == EmbreeQuery::Single) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRay one = queryOf(rays[i]).ray;
            rtcOccluded1(s.scene, &context, &one);
            occluded[i] = one.tfar < 0.0f;
        }
    } else if (query == EmbreeQuery::Packet16) {
        for (std::size_t i = 0; i < rays.size(); i += 16) {
            alignas(64) RTCRay16 packet;
            alignas(64) int valid[16];
            for (std::size_t lane = 0; lane < 16; ++lane) {
                valid[lane] = i + lane < rays.size() ? -1 : 0;
                setLane(packet, lane, rays[std::min(i + lane, rays.size() - 1)]);
            }
            rtcOccluded16(valid, s.scene, &context, &packet);
            for (std::size_t lane = 0; lane < std::min<std::size_t>(16, rays.size() - i); ++lane)
                occluded[i + lane] = packet.tfar[lane] < 0.0f;
        }
    } else {
        std::vector<RTCRay> stream(std::min(kStreamLength, rays.size()));
        for (std::size_t i = 0; i < rays.size(); i += kStreamLength) {
            const std::size_t count = std::min(kStreamLength, rays.size() - i);
            for (std::size_t k = 0; k < count; ++k) stream[k] = queryOf(rays[i + k]).ray;
            rtcOccluded1M(s.scene, &context, stream.data(), static_cast<unsigned>(count), sizeof(RTCRay));
            for (std::size_t k = 0; k < count; ++k) occluded[i + k] = stream[k].tfar < 0.0f;
        }
    }
}

}  // namespace rayscope::measure
