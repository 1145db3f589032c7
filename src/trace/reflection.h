#pragma once
// Specular and glossy reflection: members of Tracer.
#include "math/frame.h"
#include "shading/phong.h"
#include "trace/tracer.h"

namespace rayscope::trace {

/// The mirrored viewing direction; about the geometric normal where the shading normal would send it below
/// the surface.
template <PathObserver O, TermsFor<O> Terms>
glm::dvec3 Tracer<O, Terms>::mirrorDirection(const Interaction& at) const {
    const glm::dvec3 direction = shading::mirror(-at.toViewer, at.normal);
    if (glm::dot(direction, at.geometricNormal) > 0.0) return glm::normalize(direction);
    return glm::normalize(shading::mirror(-at.toViewer, at.geometricNormal));
}

template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::reflect(const Segment& segment, const Interaction& at, const Branch& branch,
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
    const Branch next{branch.key.child(1), branch.split, branch.isLast};
    if (!leaveToNextWave(mirrored, next, 0)) trace(mirrored, next);
}

/// Rays through a plane at distance 0.3 along the mirror direction, displaced in that plane by normal
/// deviates of standard deviation sigma / (3 shininess). Rays below the surface count as zero.
template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::reflectGlossy(const Segment& mirrored, const Interaction& at, const Branch& branch,
                                     const glm::dvec3& direction) {
    const int n = branch.split ? 1 : settings_.glossySamples;
    if (n == 1 || world_.hasSlowRays)
        reflectGlossy<1>(n, mirrored, at, branch, direction);
    else
        reflectGlossy<kRayGroup>(n, mirrored, at, branch, direction);
}

template <PathObserver O, TermsFor<O> Terms>
template <int kGroup>
void Tracer<O, Terms>::reflectGlossy(int n, const Segment& mirrored, const Interaction& at,
                                     const Branch& branch, const glm::dvec3& direction) {
    const math::Frame frame = math::frameAround(direction);
    const double shininess = std::max(world_.materials[at.material].shininess, 1e-6);
    const double side = static_cast<double>(settings_.glossySigma) / (3.0 * shininess);
    const sampling::SamplePoints points = stream_.points(sampling::Dim::Glossy, branch.key, 0, n);
    Segment part = mirrored;
    part.kind = RayKind::Glossy;
    part.throughput /= static_cast<double>(n);
    std::array<Ray, kGroup> rays, above;
    std::array<Hit, kGroup> hits;
    std::array<bool, kGroup> isAbove{};
    // A single ray may wait for the next wave; several are followed one after the other.
    const bool isLast = branch.isLast && n == 1;
    for (int first = 0; first < n && !stop_.stop_requested(); first += kGroup) {
        const auto count = static_cast<std::size_t>(std::min(kGroup, n - first));
        std::size_t aboveCount = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const glm::vec2 u = points.get2D(first + static_cast<int>(k));
            const glm::dvec3 displaced = 0.3 * direction + side * (sampling::normalDeviate(u.x) * frame.u +
                                                                   sampling::normalDeviate(u.y) * frame.v);
            rays[k] = {mirrored.ray.origin, glm::vec3(glm::normalize(displaced))};
            isAbove[k] = glm::dot(displaced, at.geometricNormal) > 0.0;
            if (isAbove[k]) above[aboveCount++] = rays[k];
        }
        if (!(Terms::kDefersRays && isLast)) closestHits({above.data(), aboveCount}, hits);
        std::size_t nextHit = 0;
        for (std::size_t k = 0; k < count; ++k) {
            Segment glossy = part;
            glossy.ray = rays[k];
            const auto number = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(k);
            if (isAbove[k]) {
                const Branch next{branch.key.child(number + 2), branch.split || n > 1, isLast};
                if (!leaveToNextWave(glossy, next, 0)) trace(glossy, next, &hits[nextHit++]);
            } else {
                observer_.segment(glossy);
                observer_.ended(glossy, RayEnd::BelowSurface);
            }
        }
    }
}

}  // namespace rayscope::trace
