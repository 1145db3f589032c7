#pragma once
// Traces single samples and records their events.
#include <array>

#include "support/test_scenes.h"
#include "trace/path_observer.h"
#include "trace/radiance.h"

namespace rayscope::test {

/// A camera whose whole image is one point: 2e-7 radians wide, below the rounding of floats.
inline CameraDescription pointCamera(const glm::vec3& from, const glm::vec3& at) {
    CameraDescription camera;
    camera.lookFrom = from;
    camera.lookAt = at;
    camera.fov = 1e-5f;
    const glm::vec3 along = glm::abs(glm::normalize(at - from));
    camera.up = along.y < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
    return camera;
}

/// Counts every event by kind.
struct EventCounter {
    std::array<int, 4> segments{};  ///< by RayKind
    std::array<int, 7> ends{};      ///< by RayEnd
    std::array<int, 4> lights{};    ///< light samples by Visibility
    int hits = 0, terms = 0;

    void segment(const trace::Segment& s) { ++segments[static_cast<std::size_t>(s.kind)]; }
    void hit(const trace::Interaction&) { ++hits; }
    void lightSampled(const trace::LightConnection& c, const glm::dvec3&) {
        ++lights[static_cast<std::size_t>(c.visibility)];
    }
    void added(const glm::dvec3&) { ++terms; }
    void ended(const trace::Segment&, RayEnd end) { ++ends[static_cast<std::size_t>(end)]; }

    int count(RayKind kind) const { return segments[static_cast<std::size_t>(kind)]; }
    int count(RayEnd end) const { return ends[static_cast<std::size_t>(end)]; }
    int lightSamples() const { return lights[0] + lights[1] + lights[2] + lights[3]; }
    bool operator==(const EventCounter&) const = default;
};

/// Stores the values of the events.
struct RecordingObserver {
    std::vector<trace::Segment> segments;
    std::vector<trace::Interaction> hits;
    std::vector<Ray> hitRays;  ///< rays of the hits, in the same order
    std::vector<trace::LightConnection> lights;
    std::vector<glm::dvec3> lightValues;

    void segment(const trace::Segment& s) { segments.push_back(s); }
    void hit(const trace::Interaction& at) {
        hits.push_back(at);
        hitRays.push_back(segments.back().ray);
    }
    void lightSampled(const trace::LightConnection& c, const glm::dvec3& value) {
        lights.push_back(c);
        lightValues.push_back(value);
    }
    void added(const glm::dvec3&) {}
    void ended(const trace::Segment&, RayEnd) {}
};

}  // namespace rayscope::test

namespace rayscope::trace {
// Instantiated once, in support/observers.cpp.
extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::EventCounter&,
                                      const std::stop_token&);
extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::RecordingObserver&,
                                      const std::stop_token&);
}  // namespace rayscope::trace

namespace rayscope::test {

/// The mean of the first `count` samples of a pixel.
template <class Observer>
RgbSum pixelMean(const trace::World& world, std::uint64_t seed, int x, int y, int count, Observer& observer) {
    RgbSum sum(0.0);
    for (int i = 0; i < count; ++i) sum += radiance(world, seed, {x, y, i}, observer).radiance;
    return sum / static_cast<double>(count);
}
inline RgbSum pixelMean(const trace::World& world, std::uint64_t seed, int x, int y, int count) {
    trace::NullObserver observer;
    return pixelMean(world, seed, x, y, count, observer);
}

/// One sample of the pixel (0, 0), for scenes whose radiance does not depend on random numbers.
inline RgbSum firstSample(const trace::World& world) { return pixelMean(world, 0, 0, 0, 1); }

}  // namespace rayscope::test
