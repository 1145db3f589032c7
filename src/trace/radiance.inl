#pragma once
// The tracer: Whitted's recursion with distributed light, gloss and lens sampling (Whitted 1980; Cook, Porter
// and Carpenter 1984). Every term carries its throughput, and the radiance of a sample is the left fold of
// its terms, in the order in which they are found: at once in a TermSum, or in a TermQueue when the shadow
// rays of many samples have been answered together.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "math/frame.h"
#include "sampling/sample_stream.h"
#include "sampling/warp.h"
#include "shading/environment_lookup.h"
#include "trace/camera_sample.h"
#include "trace/radiance.h"
#include "trace/shadow_ray.h"
#include "trace/term_sum.h"

namespace rayscope::trace {

constexpr int kRayGroup = 64;  ///< most rays from one point that are searched at once

struct LightTerm;

template <PathObserver O, class Terms>
class Tracer {
  public:
    Tracer(const World& world, const sampling::SampleStream& stream, const CameraSample& sample, O& observer,
           Terms& terms)
        : world_(world),
          settings_(world.settings),
          stream_(stream),
          sample_(sample),
          observer_(observer),
          terms_(terms) {}

    /// Each returns the number of rays. The second knows the camera ray and what it meets.
    std::uint64_t traceSample();
    std::uint64_t traceSample(const Ray& camera, const Hit& hit);

  private:
    /// Position in the path tree beside the segment itself.
    struct Branch {
        sampling::PathKey key;
        bool split =
            false;  ///< an earlier vertex split into several rays: take one sample of everything from here
    };

    void traceLens();
    void traceCamera(const Ray& ray, double weight, sampling::PathKey key, const Hit* known = nullptr);
    void trace(Segment& segment, Branch branch, const Hit* known = nullptr);
    bool closestHit(const Ray& ray, Hit& hit);
    void closestHits(std::span<const Ray> rays, std::span<Hit> hits);
    void shade(const Segment& segment, const Interaction& at, const Branch& branch,
               const glm::dvec3& throughput);
    void reflect(const Segment& segment, const Interaction& at, const Branch& branch,
                 const glm::dvec3& throughput);
    void reflectGlossy(const Segment& mirrored, const Interaction& at, const Branch& branch,
                       const glm::dvec3& direction);
    template <int kGroup>
    void reflectGlossy(int n, const Segment& mirrored, const Interaction& at, const Branch& branch,
                       const glm::dvec3& direction);
    bool inSharpZone();
    glm::dvec3 mirrorDirection(const Interaction& at) const;

    void addDirectLight(std::size_t light, const Interaction& at, const Branch& branch,
                        const glm::dvec3& throughput);
    template <int kGroup>
    void addDirectLight(std::size_t light, int n, const Interaction& at, const Branch& branch,
                        const glm::dvec3& throughput);
    void deferDirectLight(std::size_t light, int n, const Interaction& at, const Branch& branch,
                          const glm::dvec3& throughput);
    sampling::SamplePoints lightSamplePoints(std::size_t light, const Branch& branch, int n) const;
    LightTerm connect(std::size_t light, int k, const Interaction& at, const glm::vec3& from,
                      const sampling::SamplePoints& points) const;
    void transmittances(std::span<const Ray> shadows, std::span<double> visible);
    double transmittance(const Ray& ray);

    void add(const glm::dvec3& term) {
        terms_.add(term);
        observer_.added(term);
    }

    const World& world_;
    const Settings& settings_;
    const sampling::SampleStream& stream_;
    const CameraSample& sample_;
    O& observer_;
    Terms& terms_;
    std::uint64_t rays_ = 0;
};

template <PathObserver O, class Terms>
std::uint64_t Tracer<O, Terms>::traceSample() {
    if (hasSingleCameraRays(world_))
        traceCamera(singleCameraRay(world_, stream_, sample_), 1.0, sampling::PathKey{});
    else if (inSharpZone())
        traceCamera(world_.camera.pinholeRay(sample_.pixel), 1.0, sampling::PathKey{});
    else
        traceLens();
    return rays_;
}

template <PathObserver O, class Terms>
std::uint64_t Tracer<O, Terms>::traceSample(const Ray& camera, const Hit& hit) {
    ++rays_;
    traceCamera(camera, 1.0, sampling::PathKey{}, &hit);
    return rays_;
}

/// Splits the sample into rays through the lens; a single one keeps the root's key and its joint pattern.
template <PathObserver O, class Terms>
void Tracer<O, Terms>::traceLens() {
    const int n = settings_.lensSamples;
    std::array<Ray, kRayGroup> rays;
    std::array<Hit, kRayGroup> hits;
    for (int first = 0; first < n; first += kRayGroup) {
        const int count = std::min(kRayGroup, n - first);
        for (int k = 0; k < count; ++k) {
            const glm::vec2 u = stream_.get2D(sampling::Dim::Lens, {}, 0, first + k, n);
            rays[static_cast<std::size_t>(k)] =
                world_.camera.lensRay(sample_.pixel, sampling::sampleAperture(settings_.lensShape, u));
        }
        closestHits({rays.data(), static_cast<std::size_t>(count)}, hits);
        for (int k = 0; k < count; ++k) {
            const sampling::PathKey key =
                n == 1 ? sampling::PathKey{}
                       : sampling::PathKey{}.child(static_cast<std::uint32_t>(first + k));
            const auto i = static_cast<std::size_t>(k);
            traceCamera(rays[i], 1.0 / n, key, &hits[i]);
        }
    }
}

/// Whether the central ray of the pixel meets a surface near enough to the plane of focus to be left sharp.
template <PathObserver O, class Terms>
bool Tracer<O, Terms>::inSharpZone() {
    if (!(settings_.sharpZone > 0.0f)) return false;
    const Ray ray = world_.camera.pinholeRay(sample_.pixel);
    Hit hit;
    if (!closestHit(ray, hit)) return false;
    const glm::dvec3 point = glm::dvec3(ray.origin) + static_cast<double>(hit.t) * glm::dvec3(ray.direction);
    return std::abs(world_.camera.depthOf(point) - world_.camera.focusDistance()) <=
           static_cast<double>(settings_.sharpZone);
}

template <PathObserver O, class Terms>
bool Tracer<O, Terms>::closestHit(const Ray& ray, Hit& hit) {
    ++rays_;
    return world_.closestHit(ray, sample_.time, hit);
}

template <PathObserver O, class Terms>
void Tracer<O, Terms>::closestHits(std::span<const Ray> rays, std::span<Hit> hits) {
    rays_ += rays.size();
    world_.closestHits(rays, sample_.time, hits.first(rays.size()));
}

template <PathObserver O, class Terms>
void Tracer<O, Terms>::traceCamera(const Ray& ray, double weight, sampling::PathKey key, const Hit* known) {
    Segment segment;
    segment.ray = ray;
    segment.throughput = glm::dvec3(weight);
    segment.cone = {0.0, world_.camera.pixelAngle()};
    trace(segment, {key, false}, known);
}

/// Follows a ray through any number of transparent layers; reflections branch off by recursion. What the ray
/// meets first may be known. The segment ends as the last one.
template <PathObserver O, class Terms>
void Tracer<O, Terms>::trace(Segment& segment, Branch branch, const Hit* known) {
    for (std::uint32_t layer = 0;; ++layer) {
        observer_.segment(segment);
        Hit hit;
        if (known && layer == 0)
            hit = *known;
        else
            closestHit(segment.ray, hit);
        if (hit.primitive == kNoPrimitive) {
            if (world_.environment)
                add(segment.throughput *
                    shading::lookup(*world_.environment, glm::dvec3(segment.ray.direction)));
            return observer_.ended(segment, RayEnd::Missed);
        }
        const Interaction at = interactionAt(world_, segment.ray, sample_.time, segment.cone, hit);
        observer_.hit(at);

        const double opacity = world_.materials[at.material].opacity;
        if (opacity > 0.0) shade(segment, at, branch, opacity * segment.throughput);
        if (opacity >= 1.0) return;

        // Go on behind the surface with what it lets through, unless nothing of it could be seen any more.
        segment.throughput *= 1.0 - opacity;
        if (std::max({segment.throughput.x, segment.throughput.y, segment.throughput.z}) < 0x1p-64)
            return observer_.ended(segment, RayEnd::Vanished);
        observer_.ended(segment, RayEnd::Transmitted);
        segment.kind = RayKind::Transparent;
        segment.ray.origin = at.originBehind();
        segment.cone.width = at.coneWidth;
        branch.key = branch.key.child(~layer);
    }
}

/// The colour of a surface: its lights or its plain colour, or the reflection map, and its mirror image.
template <PathObserver O, class Terms>
void Tracer<O, Terms>::shade(const Segment& segment, const Interaction& at, const Branch& branch,
                             const glm::dvec3& throughput) {
    if (settings_.reflectionMap && world_.environment) {
        add(throughput * shading::lookup(*world_.environment, mirrorDirection(at)));
        return observer_.ended(segment, RayEnd::Absorbed);
    }
    for (std::size_t light = 0; light < world_.lights.size(); ++light)
        addDirectLight(light, at, branch, throughput);
    if (!settings_.shading && world_.lights.empty()) add(throughput * at.kd);
    reflect(segment, at, branch, throughput);
}

template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleId& name, O& observer) {
    const sampling::SampleStream stream(world.settings.sampler, seed, name.x, name.y, name.index,
                                        world.settings.spp);
    const CameraSample sample(world, stream, name);
    TermSum terms;
    const std::uint64_t rays = Tracer<O, TermSum>(world, stream, sample, observer, terms).traceSample();
    return {terms.sum, rays};
}

}  // namespace rayscope::trace

#include "trace/direct_light.inl"
#include "trace/reflection.inl"
