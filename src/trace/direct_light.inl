#pragma once
// How surfaces see lights. An end of radiance.inl.
#include "trace/radiance.inl"

namespace rayscope::trace {

/// What a position on a light would add, before it is known whether anything is in the way.
struct LightTerm {
    LightConnection connection;
    glm::dvec3 toLight{0.0};
    double distance = 0.0;  ///< its length
    glm::dvec3 reflected{0.0};
    bool needsShadow = false;
};

inline Ray shadowRay(const glm::vec3& from, const LightTerm& term) {
    return shadowRay(from, term.connection.at.position, term.toLight, term.distance);
}

/// The mean over the light of visible · phong. With shading off the surface shows its diffuse colour wherever
/// light gets: the mean over the lights of visible · kd.
template <PathObserver O, class Terms>
void Tracer<O, Terms>::addDirectLight(std::size_t index, const Interaction& at, const Branch& branch,
                                      const glm::dvec3& throughput) {
    const int n = branch.split ? 1 : world_.lights[index].grid.count();
    if constexpr (Terms::kDefersShadowRays)
        if (world_.canDeferShadowRays()) return deferDirectLight(index, n, at, branch, throughput);
    if (n == 1)
        addDirectLight<1>(index, n, at, branch, throughput);
    else
        addDirectLight<kRayGroup>(index, n, at, branch, throughput);
}

/// Asks for shadow rays in groups; terms are added in the order of the samples.
template <PathObserver O, class Terms>
template <int kGroup>
void Tracer<O, Terms>::addDirectLight(std::size_t index, int n, const Interaction& at, const Branch& branch,
                                      const glm::dvec3& throughput) {
    const sampling::SamplePoints points = lightSamplePoints(index, branch, n);
    const glm::dvec3 share = throughput / static_cast<double>(n);
    const glm::vec3 from = at.originOutside();
    std::array<LightTerm, kGroup> terms;
    std::array<Ray, kGroup> shadows;
    std::array<double, kGroup> visible;
    for (int first = 0; first < n; first += kGroup) {
        const auto count = static_cast<std::size_t>(std::min(kGroup, n - first));
        std::size_t asked = 0;
        for (std::size_t k = 0; k < count; ++k) {
            terms[k] = connect(index, first + static_cast<int>(k), at, from, points);
            if (terms[k].needsShadow) shadows[asked++] = shadowRay(from, terms[k]);
        }
        transmittances({shadows.data(), asked}, {visible.data(), asked});
        asked = 0;
        for (std::size_t k = 0; k < count; ++k) {
            LightTerm& term = terms[k];
            const double seen = term.needsShadow ? visible[asked++] : 1.0;
            if (term.needsShadow)
                term.connection.visibility = seen == 1.0  ? Visibility::Visible
                                             : seen > 0.0 ? Visibility::Attenuated
                                                          : Visibility::Occluded;
            const glm::dvec3 value = seen > 0.0 ? share * term.reflected * seen : glm::dvec3(0.0);
            observer_.lightSampled(term.connection, value);
            if (value != glm::dvec3(0.0)) add(value);
        }
    }
}

/// Leaves it to a TermQueue to ask for the shadow rays. The terms are the same.
template <PathObserver O, class Terms>
void Tracer<O, Terms>::deferDirectLight(std::size_t index, int n, const Interaction& at, const Branch& branch,
                                        const glm::dvec3& throughput) {
    const sampling::SamplePoints points = lightSamplePoints(index, branch, n);
    const glm::dvec3 share = throughput / static_cast<double>(n);
    const glm::vec3 from = at.originOutside();
    for (int k = 0; k < n; ++k) {
        const LightTerm term = connect(index, k, at, from, points);
        const glm::dvec3 value = share * term.reflected;
        rays_ += term.needsShadow ? 1 : 0;
        if (value == glm::dvec3(0.0)) continue;
        if (term.needsShadow)
            terms_.addIfVisible(value, shadowRay(from, term));
        else
            terms_.add(value);
    }
}

/// Where on the light the n samples lie; nowhere in particular for a light without extent.
template <PathObserver O, class Terms>
sampling::SamplePoints Tracer<O, Terms>::lightSamplePoints(std::size_t index, const Branch& branch,
                                                           int n) const {
    if (world_.lights[index].dimensions == 0) return {};
    return stream_.points(sampling::Dim::Light, branch.key, static_cast<std::uint32_t>(index), n);
}

/// Connects a point `from` just outside a surface with sample k on a light; what it would reflect if nothing
/// were in the way.
template <PathObserver O, class Terms>
LightTerm Tracer<O, Terms>::connect(std::size_t index, int k, const Interaction& at, const glm::vec3& from,
                                    const sampling::SamplePoints& points) const {
    const CompiledLight& compiled = world_.lights[index];
    glm::vec2 u(0.0f);
    if (compiled.dimensions == 1) u.x = points.get1D(k);
    if (compiled.dimensions == 2) u = points.get2D(k);
    LightTerm term;
    term.connection = {static_cast<int>(index), k, from, shading::sampleLight(compiled.light, u)};
    term.toLight = term.connection.at.position - glm::dvec3(from);
    term.distance = glm::length(term.toLight);
    if (settings_.shading) {
        const SurfaceMaterial& material = world_.materials[at.material];
        if (term.distance > 0.0)
            term.reflected =
                term.connection.at.color * shading::phong({at.kd, material.ks, material.shininess}, at.normal,
                                                          term.toLight * (1.0 / term.distance), at.toViewer);
        if (compiled.light.falloff == Falloff::InverseSquare)
            term.reflected /= std::max(term.distance * term.distance, 0x1p-126);
    } else {
        term.reflected = at.kd / static_cast<double>(world_.lights.size());
    }
    const bool facesAway = term.reflected == glm::dvec3(0.0);
    if (facesAway) term.connection.visibility = Visibility::FacingAway;
    term.needsShadow = compiled.castsShadows && !facesAway;
    return term;
}

template <PathObserver O, class Terms>
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

/// The fraction of light that gets along a shadow ray through whatever it crosses.
template <PathObserver O, class Terms>
double Tracer<O, Terms>::transmittance(const Ray& shadow) {
    double passed = 1.0;
    Ray ray = shadow;
    const glm::dvec3 end = glm::dvec3(shadow.origin) + glm::dvec3(shadow.direction);
    Hit hit;
    while (passed >= 0x1p-64) {
        if (!closestHit(ray, hit)) return passed;
        const Interaction at = interactionAt(world_, ray, sample_.time, {}, hit);
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

}  // namespace rayscope::trace
