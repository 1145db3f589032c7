#include "probe/non_finite.h"

#include <fmt/format.h>

#include <cmath>

#include "math/vectors.h"

namespace rayscope::probe {

namespace {

bool fitsFloat(const RgbSum& v) { return math::isFinite(Rgb(v)); }

std::string text(const RgbSum& v) { return fmt::format("({:.4g} {:.4g} {:.4g})", v.x, v.y, v.z); }

std::string locationText(const RayNode& node, std::size_t index, const trace::World& world) {
    const std::string ray = fmt::format("{} ray {}", nameOf(node.kind), index);
    return node.object >= 0 ? fmt::format("where {} hits {}", ray, objectName(world, node.object))
                            : "on " + ray;
}

/// The first value of a segment or its surface that is not finite, apart from lights.
std::string nonFiniteValueOf(const RayNode& node) {
    if (!math::isFinite(node.ray.origin) || !math::isFinite(node.ray.direction))
        return "the ray itself is not a number";
    if (!math::isFinite(node.throughput)) return "the throughput is " + text(node.throughput);
    if (!math::isFinite(node.normal)) return "the shading normal is not a number";
    if (!math::isFinite(node.geometricNormal)) return "the geometric normal is not a number";
    if (!math::isFinite(node.kd)) return "the diffuse colour is " + text(RgbSum(node.kd));
    return {};
}

std::string nonFiniteValueOf(const ShadowRay& ray) {
    const std::string light = fmt::format("light {}, sample {}", ray.light + 1, ray.sample);
    if (!math::isFinite(ray.color))
        return fmt::format("{} has the colour {}", light, text(RgbSum(ray.color)));
    if (!math::isFinite(ray.contribution)) return fmt::format("{} adds {}", light, text(ray.contribution));
    return {};
}

}  // namespace

std::string causeOfNonFinite(const RayTree& tree, const trace::World& world) {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const RayNode& node = tree.nodes[i];
        std::string cause = nonFiniteValueOf(node);
        for (const ShadowRay& ray : tree.shadowRays)
            if (cause.empty() && ray.node == static_cast<int>(i)) cause = nonFiniteValueOf(ray);
        if (cause.empty() && !math::isFinite(node.contribution))
            cause = fmt::format("{} adds {}", node.hit ? "the surface" : "the environment",
                                text(node.contribution));
        if (!cause.empty()) return fmt::format("{}: {}", locationText(node, i, world), cause);
    }
    if (!math::isFinite(tree.radiance)) return "the sum of its terms overflows: " + text(tree.radiance);
    if (!fitsFloat(tree.radiance))
        return fmt::format("the sum of its {} terms is {}, which exceeds the range of float",
                           tree.addends.size(), text(tree.radiance));
    return {};
}

}  // namespace rayscope::probe
