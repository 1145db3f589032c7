#include "probe/non_finite.h"

#include <fmt/format.h>

#include <cmath>

#include "math/vectors.h"
#include "probe/names.h"

namespace rayscope::probe {

namespace {

bool fitsFloat(const RgbSum& v) { return math::isFinite(Rgb(v)); }

std::string text(const RgbSum& v) { return fmt::format("({:.4g} {:.4g} {:.4g})", v.x, v.y, v.z); }

std::string locationText(const RayNode& node, std::size_t index, const trace::World& world) {
    const std::string ray = fmt::format("{} ray {}", nameOf(node.kind), index);
    return node.object >= 0 ? fmt::format("where {} meets {}", ray, objectName(world, node.object))
                            : "on " + ray;
}

/// What is wrong with a segment and its surface before any light comes in.
std::string wrongWith(const RayNode& node) {
    if (!math::isFinite(node.ray.origin) || !math::isFinite(node.ray.direction))
        return "the ray itself is not a number";
    if (!math::isFinite(node.throughput)) return "the throughput is " + text(node.throughput);
    if (!math::isFinite(node.normal)) return "the shading normal is not a number";
    if (!math::isFinite(node.geometricNormal)) return "the geometric normal is not a number";
    if (!math::isFinite(node.kd)) return "the diffuse colour is " + text(RgbSum(node.kd));
    return {};
}

std::string wrongWith(const ShadowRay& ray) {
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
        std::string wrong = wrongWith(node);
        for (const ShadowRay& ray : tree.shadowRays)
            if (wrong.empty() && ray.node == static_cast<int>(i)) wrong = wrongWith(ray);
        if (wrong.empty() && !math::isFinite(node.contribution))
            wrong = fmt::format("{} adds {}", node.hit ? "the surface" : "the environment",
                                text(node.contribution));
        if (!wrong.empty()) return fmt::format("{}: {}", locationText(node, i, world), wrong);
    }
    if (!math::isFinite(tree.radiance)) return "the sum of its terms overflows: " + text(tree.radiance);
    if (!fitsFloat(tree.radiance))
        return fmt::format("its {} terms add up to {}, more than a float holds", tree.addends.size(),
                           text(tree.radiance));
    return {};
}

}  // namespace rayscope::probe
