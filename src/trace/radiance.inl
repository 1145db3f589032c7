#pragma once
// The tracer: Whitted's recursion with distributed light, gloss and lens sampling (Whitted 1980; Cook, Porter
// and Carpenter 1984). Every term carries its throughput and is added to one sum, so the radiance of a sample
// is the left fold of its terms, in the order in which they are found.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "math/frame.h"
#include "sampling/sample_stream.h"
#include "sampling/warp.h"
#include "shading/environment_lookup.h"
#include "trace/radiance.h"
#include "trace/shadow_ray.h"

namespace rayscope {

constexpr int kLightGroup = 64;  ///< most shadow rays asked for at once

/// What a position on a light would add, before it is known whether anything is in the way.
struct LightTerm {
    LightConnection connection;
    glm::dvec3 reflected{0.0};
    bool needsShadow = false;
};

template <PathObserver O>
class Tracer {
  public:
    Tracer(const World& world, const SampleStream& stream, O& observer)
        : world_(world), settings_(world.settings), stream_(stream), observer_(observer) {}

    SampleResult traceSample(const SampleName& name);

  private:
    /// Position in the path tree beside the segment itself.
    struct Branch {
        PathKey key;
        bool split =
            false;  ///< an earlier vertex split into several rays: take one sample of everything from here
    };

    void traceCamera(const glm::dvec2& pixel, const glm::dvec2& aperture, double weight, PathKey key);
    void trace(Segment segment, Branch branch);
    void shade(const Segment& segment, const Interaction& at, const Branch& branch,
               const glm::dvec3& throughput);
    void shadeByLight(std::size_t light, const Interaction& at, const Branch& branch,
                      const glm::dvec3& throughput);
    void reflect(const Segment& segment, const Interaction& at, const Branch& branch,
                 const glm::dvec3& throughput);
    void reflectGlossy(const Segment& mirrored, const Interaction& at, const Branch& branch,
                       const glm::dvec3& direction);
    template <int kGroup>
    void shadeByLight(std::size_t light, int n, const Interaction& at, const Branch& branch,
                      const glm::dvec3& throughput);
    LightTerm connect(std::size_t light, int sample, const Interaction& at, const glm::vec3& from,
                      const glm::vec2& u) const;
    void transmittances(std::span<const Ray> shadows, std::span<double> visible);
    double transmittance(const Ray& ray);
    bool inSharpZone(const glm::dvec2& pixel);
    glm::dvec3 mirrorDirection(const Interaction& at) const;
    void add(const glm::dvec3& term) {
        sum_ += term;
        observer_.added(term);
    }

    const World& world_;
    const Settings& settings_;
    const SampleStream& stream_;
    O& observer_;
    RgbSum sum_{0.0};
    std::uint64_t rays_ = 0;
    float time_ = 0.0f;
};

template <PathObserver O>
SampleResult Tracer<O>::traceSample(const SampleName& name) {
    const glm::dvec2 pixel = glm::dvec2(name.x, name.y) + glm::dvec2(stream_.get2D(Dim::Pixel));
    if (world_.moves) time_ = stream_.get1D(Dim::Time);
    if (!world_.camera.hasLens() || inSharpZone(pixel)) {
        traceCamera(pixel, glm::dvec2(0.0), 1.0, PathKey{});
        return {sum_, rays_};
    }
    // Split the pixel sample into rays through the lens; a single one keeps the root's key and its joint
    // pattern.
    const int n = settings_.lensSamples;
    for (int k = 0; k < n; ++k) {
        const glm::vec2 u = stream_.get2D(Dim::Lens, {}, 0, k, n);
        const PathKey key = n == 1 ? PathKey{} : PathKey{}.child(static_cast<std::uint32_t>(k));
        traceCamera(pixel, sampleAperture(settings_.lensShape, u), 1.0 / n, key);
    }
    return {sum_, rays_};
}

/// Whether the central ray of the pixel meets a surface near enough to the plane of focus to be left sharp.
template <PathObserver O>
bool Tracer<O>::inSharpZone(const glm::dvec2& pixel) {
    if (!(settings_.sharpZone > 0.0f)) return false;
    const Ray ray = world_.camera.pinholeRay(pixel);
    Hit hit;
    ++rays_;
    if (!world_.closestHit(ray, time_, hit)) return false;
    const glm::dvec3 point = glm::dvec3(ray.origin) + static_cast<double>(hit.t) * glm::dvec3(ray.direction);
    return std::abs(world_.camera.depthOf(point) - world_.camera.focusDistance()) <=
           static_cast<double>(settings_.sharpZone);
}

template <PathObserver O>
void Tracer<O>::traceCamera(const glm::dvec2& pixel, const glm::dvec2& aperture, double weight, PathKey key) {
    Segment segment;
    segment.ray = world_.camera.lensRay(pixel, aperture);
    segment.throughput = glm::dvec3(weight);
    segment.cone = {0.0, world_.camera.pixelAngle()};
    trace(segment, {key, false});
}

/// Follows a ray through any number of transparent layers; reflections branch off by recursion.
template <PathObserver O>
void Tracer<O>::trace(Segment segment, Branch branch) {
    for (std::uint32_t layer = 0;; ++layer) {
        observer_.segment(segment);
        Hit hit;
        ++rays_;
        if (!world_.closestHit(segment.ray, time_, hit)) {
            if (world_.environment)
                add(segment.throughput * lookup(*world_.environment, glm::dvec3(segment.ray.direction)));
            return observer_.ended(segment, RayEnd::Missed);
        }
        const Interaction at = interactionAt(world_, segment.ray, time_, segment.cone, hit);
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
template <PathObserver O>
void Tracer<O>::shade(const Segment& segment, const Interaction& at, const Branch& branch,
                      const glm::dvec3& throughput) {
    if (settings_.reflectionMap && world_.environment) {
        add(throughput * lookup(*world_.environment, mirrorDirection(at)));
        return observer_.ended(segment, RayEnd::Absorbed);
    }
    for (std::size_t light = 0; light < world_.lights.size(); ++light)
        shadeByLight(light, at, branch, throughput);
    if (!settings_.shading && world_.lights.empty()) add(throughput * at.kd);
    reflect(segment, at, branch, throughput);
}

/// The mean over the light of visible · phong. With shading off the surface shows its diffuse colour wherever
/// light gets: the mean over the lights of visible · kd.
template <PathObserver O>
void Tracer<O>::shadeByLight(std::size_t index, const Interaction& at, const Branch& branch,
                             const glm::dvec3& throughput) {
    const int n = branch.split ? 1 : world_.lights[index].grid.count();
    if (n == 1)
        shadeByLight<1>(index, n, at, branch, throughput);
    else
        shadeByLight<kLightGroup>(index, n, at, branch, throughput);
}

/// Asks for shadow rays in groups; terms are added in the order of the samples.
template <PathObserver O>
template <int kGroup>
void Tracer<O>::shadeByLight(std::size_t index, int n, const Interaction& at, const Branch& branch,
                             const glm::dvec3& throughput) {
    const CompiledLight& compiled = world_.lights[index];
    const SamplePoints points = stream_.points(Dim::Light, branch.key, static_cast<std::uint32_t>(index), n);
    const glm::vec3 from = at.originOutside();
    std::array<LightTerm, kGroup> terms;
    std::array<Ray, kGroup> shadows;
    std::array<double, kGroup> visible;
    for (int first = 0; first < n; first += kGroup) {
        const int count = std::min(kGroup, n - first);
        std::size_t asked = 0;
        for (int k = 0; k < count; ++k) {
            glm::vec2 u(0.0f);
            if (compiled.dimensions == 1) u.x = points.get1D(first + k);
            if (compiled.dimensions == 2) u = points.get2D(first + k);
            LightTerm& term = terms[static_cast<std::size_t>(k)];
            term = connect(index, first + k, at, from, u);
            if (term.needsShadow)
                shadows[asked++] = shadowRay(term.connection.from, term.connection.at.position);
        }
        transmittances({shadows.data(), asked}, {visible.data(), asked});
        asked = 0;
        for (int k = 0; k < count; ++k) {
            LightTerm& term = terms[static_cast<std::size_t>(k)];
            const double seen = term.needsShadow ? visible[asked++] : 1.0;
            if (term.needsShadow)
                term.connection.visibility = seen == 1.0  ? Visibility::Visible
                                             : seen > 0.0 ? Visibility::Attenuated
                                                          : Visibility::Blocked;
            const glm::dvec3 value = throughput * term.reflected * seen / static_cast<double>(n);
            observer_.lightSampled(term.connection, value);
            if (value != glm::dvec3(0.0)) add(value);
        }
    }
}

/// Connects a point `from` just outside a surface with a position on a light; what it would reflect if
/// nothing were in the way.
template <PathObserver O>
LightTerm Tracer<O>::connect(std::size_t index, int sample, const Interaction& at, const glm::vec3& from,
                             const glm::vec2& u) const {
    const CompiledLight& compiled = world_.lights[index];
    LightTerm term;
    term.connection = {static_cast<int>(index), sample, from, sampleLight(compiled.light, u)};
    if (settings_.shading) {
        const SurfaceMaterial& material = world_.materials[at.material];
        const glm::dvec3 toLight = term.connection.at.position - glm::dvec3(from);
        const double distance = glm::length(toLight);
        if (distance > 0.0)
            term.reflected = term.connection.at.color * phong({at.kd, material.ks, material.shininess},
                                                              at.normal, toLight / distance, at.toViewer);
        if (compiled.light.falloff == Falloff::InverseSquare)
            term.reflected /= std::max(distance * distance, 0x1p-126);
    } else {
        term.reflected = at.kd / static_cast<double>(world_.lights.size());
    }
    const bool facesAway = term.reflected == glm::dvec3(0.0);
    if (facesAway) term.connection.visibility = Visibility::FacingAway;
    term.needsShadow = compiled.castsShadows && !facesAway;
    return term;
}

template <PathObserver O>
void Tracer<O>::transmittances(std::span<const Ray> shadows, std::span<double> visible) {
    if (world_.attenuatesShadows) {
        for (std::size_t i = 0; i < shadows.size(); ++i) visible[i] = transmittance(shadows[i]);
        return;
    }
    std::array<std::uint8_t, kLightGroup> occluded;
    world_.anyHits(shadows, time_, {occluded.data(), shadows.size()});
    rays_ += shadows.size();
    for (std::size_t i = 0; i < shadows.size(); ++i) visible[i] = occluded[i] ? 0.0 : 1.0;
}

/// The fraction of light that gets along a shadow ray through whatever it crosses.
template <PathObserver O>
double Tracer<O>::transmittance(const Ray& shadow) {
    double passed = 1.0;
    Ray ray = shadow;
    const glm::dvec3 end = glm::dvec3(shadow.origin) + glm::dvec3(shadow.direction);
    Hit hit;
    while (passed >= 0x1p-64) {
        ++rays_;
        if (!world_.closestHit(ray, time_, hit)) return passed;
        const Interaction at = interactionAt(world_, ray, time_, {}, hit);
        passed *= 1.0 - world_.materials[at.material].opacity;
        // Go on from behind the surface to the same end.
        ray.origin = at.originBehind();
        const glm::dvec3 rest = end - glm::dvec3(ray.origin);
        const double done = 1.0 - glm::dot(rest, glm::dvec3(shadow.direction)) /
                                      glm::dot(glm::dvec3(shadow.direction), glm::dvec3(shadow.direction));
        if (!(done < static_cast<double>(shadow.tMax))) return passed;
        ray.tMax = static_cast<float>(static_cast<double>(shadow.tMax) - done);
    }
    return 0.0;
}

/// The mirrored viewing direction; about the geometric normal where the shading normal would send it below
/// ground.
template <PathObserver O>
glm::dvec3 Tracer<O>::mirrorDirection(const Interaction& at) const {
    const glm::dvec3 direction = mirror(-at.toViewer, at.normal);
    if (glm::dot(direction, at.geometricNormal) > 0.0) return glm::normalize(direction);
    return glm::normalize(mirror(-at.toViewer, at.geometricNormal));
}

template <PathObserver O>
void Tracer<O>::reflect(const Segment& segment, const Interaction& at, const Branch& branch,
                        const glm::dvec3& throughput) {
    const SurfaceMaterial& material = world_.materials[at.material];
    if (!material.reflects) return observer_.ended(segment, RayEnd::Absorbed);
    if (segment.depth >= settings_.maxDepth) return observer_.ended(segment, RayEnd::DepthLimit);

    const glm::dvec3 direction = mirrorDirection(at);
    Segment mirrored;
    mirrored.kind = RayKind::Reflection;
    mirrored.depth = segment.depth + 1;
    mirrored.throughput = throughput * material.ks;
    mirrored.cone = {at.coneWidth, segment.cone.spread};
    mirrored.ray = {at.originOutside(), glm::vec3(direction)};
    observer_.ended(segment, RayEnd::Reflected);
    if (settings_.glossy && settings_.glossySigma > 0.0f)
        return reflectGlossy(mirrored, at, branch, direction);
    trace(mirrored, {branch.key.child(1), branch.split});
}

/// Rays through a square that stands at distance 0.3 along the reflection, displaced in its plane by normal
/// deviates of standard deviation sigma / (3 shininess). Rays below the surface count as zero.
template <PathObserver O>
void Tracer<O>::reflectGlossy(const Segment& mirrored, const Interaction& at, const Branch& branch,
                              const glm::dvec3& direction) {
    const Frame frame = frameAround(direction);
    const double shininess = std::max(world_.materials[at.material].shininess, 1e-6);
    const double side = static_cast<double>(settings_.glossySigma) / (3.0 * shininess);
    const int n = branch.split ? 1 : settings_.glossySamples;
    const SamplePoints points = stream_.points(Dim::Glossy, branch.key, 0, n);
    for (int k = 0; k < n; ++k) {
        const glm::vec2 u = points.get2D(k);
        const glm::dvec3 displaced =
            0.3 * direction + side * (normalDeviate(u.x) * frame.u + normalDeviate(u.y) * frame.v);
        Segment ray = mirrored;
        ray.kind = RayKind::Glossy;
        ray.throughput /= static_cast<double>(n);
        ray.ray.direction = glm::vec3(glm::normalize(displaced));
        if (!(glm::dot(displaced, at.geometricNormal) > 0.0)) {
            observer_.segment(ray);
            observer_.ended(ray, RayEnd::BelowSurface);
            continue;
        }
        trace(ray, {branch.key.child(static_cast<std::uint32_t>(k) + 2), branch.split || n > 1});
    }
}

template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleName& name, O& observer) {
    const SampleStream stream(world.settings.sampler, seed, name.x, name.y, name.index, world.settings.spp);
    return Tracer<O>(world, stream, observer).traceSample(name);
}

}  // namespace rayscope
