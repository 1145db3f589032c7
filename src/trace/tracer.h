#pragma once
// Whitted's recursion with distributed light, glossy and lens sampling (Whitted 1980; Cook, Porter and
// Carpenter 1984). Every term carries its throughput, and the radiance of a sample is the left fold of its
// terms, in the order in which the path produces them.
//
// Members are defined in this file (camera rays, the path), direct_lighting.h and reflection.h;
// radiance_definition.h includes all of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stop_token>

#include "sampling/sample_stream.h"
#include "sampling/warp.h"
#include "shading/environment_lookup.h"
#include "trace/camera_sample.h"
#include "trace/path_observer.h"
#include "trace/pending_path.h"
#include "trace/term_sum.h"
#include "trace/world.h"

namespace rayscope::trace {

constexpr int kRayGroup = 64;  ///< most rays from one point that are traced as a batch

struct LightTerm;

/// Traces one sample. `Terms` receives the terms: TermSum, or TermQueue for many samples, which also receives
/// the paths that continue in the next wave. After a stop request the rest of the sample is left out, and
/// what `Terms` received is meaningless.
template <PathObserver O, TermsFor<O> Terms>
class Tracer {
  public:
    Tracer(const World& world, const sampling::SampleStream& stream, const CameraSample& sample, O& observer,
           Terms& terms, const std::stop_token& stop)
        : world_(world),
          settings_(world.settings),
          stream_(stream),
          sample_(sample),
          observer_(observer),
          terms_(terms),
          stop_(stop) {}

    /// Returns the number of rays.
    std::uint64_t traceSample();
    /// The same for the sample's only camera ray and its closest hit, where hasSingleCameraRays().
    std::uint64_t traceSample(const Ray& camera, const Hit& hit);
    /// Continues a path that was left to a later wave, with the closest hit of its ray; advances its segment.
    /// Returns the number of further rays, that one included.
    std::uint64_t tracePath(PendingPath& path, const Hit& hit);

  private:
    using Branch = PathBranch;

    void traceLens();
    bool inSharpZone();
    void traceCamera(const Ray& ray, double weight, const Branch& branch, const Hit* known = nullptr);
    void trace(Segment& segment, Branch branch, const Hit* known = nullptr, std::uint32_t layer = 0);
    bool leaveToNextWave(const Segment& segment, const Branch& branch, std::uint32_t layer);
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
    glm::dvec3 mirrorDirection(const Interaction& at) const;

    void addDirectLight(std::size_t light, const Interaction& at, const Branch& branch,
                        const glm::dvec3& throughput);
    template <int kGroup, class Shape>
    void addDirectLight(const Shape& shape, std::size_t light, int n, const Interaction& at,
                        const Branch& branch, const glm::dvec3& throughput);
    template <class Shape>
    void deferDirectLight(Shape shape, std::size_t light, int n, const Interaction& at, const Branch& branch,
                          const glm::dvec3& throughput);
    sampling::SamplePoints lightSamplePoints(std::size_t light, const Branch& branch, int n) const;
    template <class Shape>
    void connect(const Shape& shape, std::size_t light, int k, const Interaction& at, const glm::vec3& from,
                 const sampling::SamplePoints& points, LightTerm& term) const;
    void addLightTerm(LightTerm& term, const glm::dvec3& weight, double visible);
    void deferLightTerm(const LightTerm& term, const glm::dvec3& weight);
    void transmittances(std::span<const Ray> shadows, std::span<double> visible);
    double transmittance(const Ray& shadow);

    /// The most rays between two checks for a stop, a power of two.
    int raysPerCheck() const { return world_.hasSlowRays ? 1 : kRayGroup; }

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
    const std::stop_token& stop_;
    std::uint64_t rays_ = 0;
};

template <PathObserver O, TermsFor<O> Terms>
std::uint64_t Tracer<O, Terms>::traceSample() {
    if (hasSingleCameraRays(world_))
        traceCamera(singleCameraRay(world_, stream_, sample_), 1.0, {});
    else if (inSharpZone())
        traceCamera(world_.camera.pinholeRay(sample_.pixel), 1.0, {});
    else
        traceLens();
    return rays_;
}

template <PathObserver O, TermsFor<O> Terms>
std::uint64_t Tracer<O, Terms>::traceSample(const Ray& camera, const Hit& hit) {
    ++rays_;
    traceCamera(camera, 1.0, {.isLast = true}, &hit);
    return rays_;
}

template <PathObserver O, TermsFor<O> Terms>
std::uint64_t Tracer<O, Terms>::tracePath(PendingPath& path, const Hit& hit) {
    ++rays_;
    trace(path.segment, path.branch, &hit, path.layer);
    return rays_;
}

/// Splits the sample into rays through the lens. A single ray keeps the key of the root, so that its lens
/// point stays stratified over the samples of the pixel.
template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::traceLens() {
    const int n = settings_.lensSamples;
    std::array<Ray, kRayGroup> rays;
    std::array<Hit, kRayGroup> hits;
    const int group = raysPerCheck();
    for (int first = 0; first < n && !stop_.stop_requested(); first += group) {
        const int count = std::min(group, n - first);
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
            traceCamera(rays[i], 1.0 / n, {.key = key}, &hits[i]);
        }
    }
}

/// Whether the pinhole ray hits a surface within `sharp_zone` of the plane of focus.
template <PathObserver O, TermsFor<O> Terms>
bool Tracer<O, Terms>::inSharpZone() {
    if (!(settings_.sharpZone > 0.0f)) return false;
    const Ray ray = world_.camera.pinholeRay(sample_.pixel);
    Hit hit;
    if (!closestHit(ray, hit)) return false;
    const glm::dvec3 point = glm::dvec3(ray.origin) + static_cast<double>(hit.t) * glm::dvec3(ray.direction);
    return std::abs(world_.camera.depthOf(point) - world_.camera.focusDistance()) <=
           static_cast<double>(settings_.sharpZone);
}

template <PathObserver O, TermsFor<O> Terms>
bool Tracer<O, Terms>::closestHit(const Ray& ray, Hit& hit) {
    ++rays_;
    return world_.closestHit(ray, sample_.time, hit);
}

template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::closestHits(std::span<const Ray> rays, std::span<Hit> hits) {
    rays_ += rays.size();
    world_.closestHits(rays, sample_.time, hits.first(rays.size()));
}

template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::traceCamera(const Ray& ray, double weight, const Branch& branch, const Hit* known) {
    Segment segment;
    segment.ray = ray;
    segment.throughput = glm::dvec3(weight);
    segment.cone = {0.0, world_.camera.pixelAngle()};
    trace(segment, branch, known);
}

/// Whether the path has been left to the next wave, which traces the ray of the segment.
template <PathObserver O, TermsFor<O> Terms>
bool Tracer<O, Terms>::leaveToNextWave(const Segment& segment, const Branch& branch, std::uint32_t layer) {
    if constexpr (Terms::kDefersRays) {
        if (branch.isLast) terms_.addPath(segment, branch, layer);
        return branch.isLast;
    }
    return false;
}

/// Follows a ray through any number of transparent layers; reflections recurse. `known` is the first closest
/// hit if it has been computed, `layer` the number of layers that the path has crossed before.
template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::trace(Segment& segment, Branch branch, const Hit* known, std::uint32_t layer) {
    for (;; ++layer) {
        observer_.segment(segment);
        Hit hit;
        if (known)
            hit = *known;
        else
            closestHit(segment.ray, hit);
        known = nullptr;
        if (hit.primitive == kNoPrimitive) {
            if (world_.environment)
                add(segment.throughput *
                    shading::lookup(*world_.environment, glm::dvec3(segment.ray.direction)));
            return observer_.ended(segment, RayEnd::Missed);
        }
        const Interaction at = interactionAt(world_, segment.ray, sample_.time, segment.cone, hit);
        observer_.hit(at);

        const double opacity = world_.materials[at.material].opacity;
        const bool isOpaque = opacity >= 1.0;
        if (opacity > 0.0)
            shade(segment, at, {branch.key, branch.split, branch.isLast && isOpaque},
                  opacity * segment.throughput);
        if (isOpaque) return;

        // Continue behind the surface unless the remaining throughput is negligible.
        segment.throughput *= 1.0 - opacity;
        if (std::max({segment.throughput.x, segment.throughput.y, segment.throughput.z}) < 0x1p-64)
            return observer_.ended(segment, RayEnd::Vanished);
        observer_.ended(segment, RayEnd::Transmitted);
        segment.kind = RayKind::Transparent;
        segment.ray.origin = at.originBehind();
        segment.cone.width = at.coneWidth;
        branch.key = branch.key.child(~layer);
        if (leaveToNextWave(segment, branch, layer + 1) || stop_.stop_requested()) return;
    }
}

/// Adds direct lighting and reflections; with `reflection_map`, the environment in the mirror direction
/// instead.
template <PathObserver O, TermsFor<O> Terms>
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

}  // namespace rayscope::trace
