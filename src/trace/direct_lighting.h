#pragma once
// Direct lighting: members of Tracer that sample lights and trace shadow rays.
#include <variant>

#include "shading/light_sample.h"
#include "shading/phong.h"
#include "trace/shadow_ray.h"
#include "trace/shadow_walk.h"
#include "trace/tracer.h"

namespace rayscope::trace {

/// A light sample and the radiance that the surface reflects of it if it is not occluded.
struct LightTerm {
    LightConnection connection;
    glm::dvec3 toLight{0.0};
    double distance = 0.0;  ///< length of `toLight`
    glm::dvec3 reflected{0.0};
    bool needsShadow = false;
};

inline Ray shadowRay(const LightTerm& term) {
    return shadowRay(term.connection.from, term.connection.at.position, term.toLight, term.distance);
}

/// Adds the mean of visibility · phong over the samples of a light; without shading, the mean of
/// visibility · kd over the samples of all lights.
template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::addDirectLight(std::size_t light, const Interaction& at, const Branch& branch,
                                      const glm::dvec3& throughput) {
    const int n = branch.split ? 1 : world_.lights[light].grid.count();
    const auto add = [&](const auto& shape) {
        if constexpr (Terms::kDefersRays)
            if (world_.canDeferShadowRays()) return deferDirectLight(shape, light, n, at, branch, throughput);
        if (n == 1 || world_.hasSlowRays)
            addDirectLight<1>(shape, light, n, at, branch, throughput);
        else
            addDirectLight<kRayGroup>(shape, light, n, at, branch, throughput);
    };
    std::visit(add, world_.lights[light].light.shape);
}

/// Traces the shadow rays of kGroup samples as a batch. Terms are added in the order of the samples.
template <PathObserver O, TermsFor<O> Terms>
template <int kGroup, class Shape>
void Tracer<O, Terms>::addDirectLight(const Shape& shape, std::size_t light, int n, const Interaction& at,
                                      const Branch& branch, const glm::dvec3& throughput) {
    const sampling::SamplePoints points = lightSamplePoints(light, branch, n);
    const glm::dvec3 weight = throughput / static_cast<double>(n);
    const glm::vec3 from = at.originOutside();
    std::array<LightTerm, kGroup> terms;
    std::array<Ray, kGroup> shadows;
    std::array<double, kGroup> visible;
    const int perCheck = raysPerCheck();
    for (int first = 0; first < n; first += kGroup) {
        if ((first & (perCheck - 1)) == 0 && stop_.stop_requested()) return;
        const auto count = static_cast<std::size_t>(std::min(kGroup, n - first));
        std::size_t shadowCount = 0;
        for (std::size_t k = 0; k < count; ++k) {
            connect(shape, light, first + static_cast<int>(k), at, from, points, terms[k]);
            if (terms[k].needsShadow) shadows[shadowCount++] = shadowRay(terms[k]);
        }
        transmittances({shadows.data(), shadowCount}, {visible.data(), shadowCount});
        std::size_t nextShadow = 0;
        for (std::size_t k = 0; k < count; ++k)
            addLightTerm(terms[k], weight, terms[k].needsShadow ? visible[nextShadow++] : 1.0);
    }
}

/// Leaves the shadow rays to the TermQueue, which makes batches of its own. The shape is a copy, because what
/// the queue stores might overwrite what a reference refers to, for all that the compiler knows.
template <PathObserver O, TermsFor<O> Terms>
template <class Shape>
void Tracer<O, Terms>::deferDirectLight(const Shape shape, std::size_t light, int n, const Interaction& at,
                                        const Branch& branch, const glm::dvec3& throughput) {
    const sampling::SamplePoints points = lightSamplePoints(light, branch, n);
    const glm::dvec3 weight = throughput / static_cast<double>(n);
    const glm::vec3 from = at.originOutside();
    const int perCheck = raysPerCheck();
    for (int k = 0; k < n; ++k) {
        if ((k & (perCheck - 1)) == 0 && stop_.stop_requested()) return;
        LightTerm term;
        connect(shape, light, k, at, from, points, term);
        deferLightTerm(term, weight);
    }
}

template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::addLightTerm(LightTerm& term, const glm::dvec3& weight, double visible) {
    if (term.needsShadow)
        term.connection.visibility = visible == 1.0  ? Visibility::Visible
                                     : visible > 0.0 ? Visibility::Attenuated
                                                     : Visibility::Occluded;
    const glm::dvec3 value = visible > 0.0 ? weight * term.reflected * visible : glm::dvec3(0.0);
    observer_.lightSampled(term.connection, value);
    if (value != glm::dvec3(0.0)) add(value);
}

/// Queues the term with its shadow ray, which counts as traced. The observer is the NullObserver (see
/// TermsFor).
template <PathObserver O, TermsFor<O> Terms>
[[gnu::always_inline]] inline void Tracer<O, Terms>::deferLightTerm(const LightTerm& term,
                                                                    const glm::dvec3& weight) {
    const glm::dvec3 value = weight * term.reflected;
    rays_ += term.needsShadow ? 1 : 0;
    if (value == glm::dvec3(0.0)) return;
    if (term.needsShadow)
        terms_.addIfVisible(value, shadowRay(term));
    else
        terms_.add(value);
}

/// The points of the unit square that the n light samples are mapped from; unused by point lights.
template <PathObserver O, TermsFor<O> Terms>
sampling::SamplePoints Tracer<O, Terms>::lightSamplePoints(std::size_t light, const Branch& branch,
                                                           int n) const {
    if (world_.lights[light].dimensions == 0) return {};
    return stream_.points(sampling::Dim::Light, branch.key, static_cast<std::uint32_t>(light), n);
}

/// Connects `from`, the spawned origin of the surface, with sample k of a light. Sets every member of `term`.
/// Inlined, so that members which the caller does not read are not computed.
template <PathObserver O, TermsFor<O> Terms>
template <class Shape>
[[gnu::always_inline]] inline void Tracer<O, Terms>::connect(const Shape& shape, std::size_t light, int k,
                                                             const Interaction& at, const glm::vec3& from,
                                                             const sampling::SamplePoints& points,
                                                             LightTerm& term) const {
    const CompiledLight& compiled = world_.lights[light];
    constexpr int kDimensions = shading::dimensionsOf(Shape{});
    glm::vec2 u(0.0f);
    if constexpr (kDimensions == 1) u.x = points.get1D(k);
    if constexpr (kDimensions == 2) u = points.get2D(k);
    // Locals, because values that are stored to `term` and loaded again in wider registers stall the
    // processor.
    const shading::LightSample sample = shading::sampleLight(shape, glm::dvec2(u));
    const glm::dvec3 toLight = sample.position - glm::dvec3(from);
    const double distance = glm::length(toLight);
    glm::dvec3 reflected(0.0);
    if (settings_.shading) {
        const SurfaceMaterial& material = world_.materials[at.material];
        if (distance > 0.0)
            reflected = sample.color * shading::phong({at.kd, material.ks, material.shininess}, at.normal,
                                                      toLight * (1.0 / distance), at.toViewer);
        if (compiled.light.falloff == Falloff::InverseSquare) {
            // On the light itself the quotient diverges; the bound is the largest that images hold as float.
            constexpr double kSmallest = 0x1p-1000, kLargest = 0x1p126;
            reflected = glm::min(reflected / std::max(distance * distance, kSmallest), glm::dvec3(kLargest));
        }
    } else {
        reflected = at.kd / static_cast<double>(world_.lights.size());
    }
    const bool facesAway = reflected == glm::dvec3(0.0);
    term.connection = {static_cast<int>(light), k, from, sample,
                       facesAway ? Visibility::FacingAway : Visibility::Visible};
    term.toLight = toLight;
    term.distance = distance;
    term.reflected = reflected;
    term.needsShadow = compiled.castsShadows && !facesAway;
}

template <PathObserver O, TermsFor<O> Terms>
void Tracer<O, Terms>::transmittances(std::span<const Ray> shadows, std::span<double> visible) {
    if (world_.attenuatesShadows) {
        for (std::size_t i = 0; i < shadows.size(); ++i) visible[i] = transmittance(shadows[i]);
        return;
    }
    std::array<std::uint8_t, kRayGroup> occluded;
    world_.anyHits(shadows, sample_.time, {occluded.data(), shadows.size()});
    rays_ += shadows.size();
    for (std::size_t i = 0; i < shadows.size(); ++i) visible[i] = occluded[i] ? 0.0 : 1.0;
}

template <PathObserver O, TermsFor<O> Terms>
double Tracer<O, Terms>::transmittance(const Ray& shadow) {
    return transmittanceAlong(world_, shadow, sample_.time, stop_, [this](const Ray&) { ++rays_; });
}

}  // namespace rayscope::trace
