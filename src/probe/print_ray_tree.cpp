#include <fmt/format.h>

#include <rayscope/probe.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/check_argument.h"
#include "math/vectors.h"
#include "probe/names.h"
#include "trace/world.h"

namespace rayscope {

namespace {

template <class V>
std::string text(const V& v) {
    return fmt::format("({:.6g} {:.6g} {:.6g})", v.x, v.y, v.z);
}
template <class V>
nlohmann::json json(const V& v) {
    return nlohmann::json::array({v.x, v.y, v.z});
}

std::string describe(const RayNode& node, const trace::World& world) {
    std::string line = fmt::format("{} ray, throughput {}", probe::nameOf(node.kind), text(node.throughput));
    if (!node.hit)
        return line + fmt::format(": {}, adds {}", probe::nameOf(node.end), text(node.contribution));
    const trace::PrimitiveLocation name = world.locatePrimitive(node.primitiveHit.primitive);
    const std::string color =
        name.range->colors ? fmt::format(" with vertex colours, kd {}", text(node.kd)) : std::string{};
    return line +
           fmt::format(": t {:.9g} hits {} {} {}, u {:.6g} v {:.6g}, material '{}'{}, normal {}, adds {}, {}",
                       node.primitiveHit.t, probe::objectName(world, node.object),
                       name.range->mesh ? "triangle" : "number", name.inObject, node.primitiveHit.u,
                       node.primitiveHit.v,
                       world.description->materials[static_cast<std::size_t>(node.material)].name, color,
                       text(node.normal), text(node.contribution), probe::nameOf(node.end));
}

nlohmann::json nodeJson(const RayNode& node, const trace::World& world) {
    nlohmann::json j = {{"parent", node.parent},
                        {"kind", probe::nameOf(node.kind)},
                        {"depth", node.depth},
                        {"origin", json(node.ray.origin)},
                        {"direction", json(node.ray.direction)},
                        {"throughput", json(node.throughput)},
                        {"contribution", json(node.contribution)},
                        {"end", probe::nameOf(node.end)},
                        {"hit", nullptr}};
    if (!node.hit) return j;
    const trace::PrimitiveLocation name = world.locatePrimitive(node.primitiveHit.primitive);
    j["hit"] = {{"t", node.primitiveHit.t},
                {"primitive", node.primitiveHit.primitive},
                {"object", probe::objectName(world, node.object)},
                {"triangle", name.inObject},
                {"u", node.primitiveHit.u},
                {"v", node.primitiveHit.v},
                {"material", world.description->materials[static_cast<std::size_t>(node.material)].name},
                {"position", json(node.position)},
                {"geometric_normal", json(node.geometricNormal)},
                {"normal", json(node.normal)},
                {"kd", json(node.kd)},
                {"opacity", node.opacity},
                {"uv", {node.uv.x, node.uv.y}}};
    return j;
}

/// Group names of Wavefront OBJ have no blanks.
std::string groupName(std::string_view name) {
    std::string group(name);
    std::replace(group.begin(), group.end(), ' ', '_');
    return group;
}

/// Throws std::invalid_argument if an index of the tree does not refer to the tree or to the world.
void checkTree(const RayTree& tree, const trace::World& world) {
    const SceneDescription& scene = *world.description;
    const auto isIndex = [](int index, std::size_t count) {
        return index >= 0 && static_cast<std::size_t>(index) < count;
    };
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const RayNode& node = tree.nodes[i];
        base::checkArgument(node.parent == -1 || isIndex(node.parent, i), "tree: nodes[{}] has parent {}", i,
                            node.parent);
        if (!node.hit) continue;
        base::checkArgument(node.primitiveHit.primitive < world.primitiveCount() &&
                                isIndex(node.object, scene.meshes.size() + scene.spheres.size()) &&
                                isIndex(node.material, scene.materials.size()),
                            "tree: nodes[{}] hits what the world does not contain", i);
    }
}

glm::vec3 endOf(const RayNode& node, float missLength) {
    if (node.hit) return node.position;
    const double length = math::length(node.ray.direction);
    if (!(length > 0.0)) return node.ray.origin;
    return node.ray.origin +
           glm::vec3(glm::dvec3(node.ray.direction) * (static_cast<double>(missLength) / length));
}

}  // namespace

std::string toText(const RayTree& tree, const trace::World& world) {
    checkTree(tree, world);
    std::string out = fmt::format("pixel {},{} sample {}: radiance {}\n", tree.name.x, tree.name.y,
                                  tree.name.index, text(tree.radiance));
    // Shadow rays are recorded in the order of the nodes they belong to.
    std::size_t shadow = 0;
    std::vector<int> level(tree.nodes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const RayNode& node = tree.nodes[i];
        if (node.parent >= 0) level[i] = level[static_cast<std::size_t>(node.parent)] + 1;
        const std::string indent(static_cast<std::size_t>(2 * (level[i] + 1)), ' ');
        out += fmt::format("{}[{}] {}\n", indent, i, describe(node, world));
        for (; shadow < tree.shadowRays.size() && tree.shadowRays[shadow].node == static_cast<int>(i);
             ++shadow) {
            const ShadowRay& ray = tree.shadowRays[shadow];
            out += fmt::format("{}  light {} sample {} at {}: {}, adds {}\n", indent, ray.light, ray.sample,
                               text(ray.to), probe::nameOf(ray.visibility), text(ray.contribution));
        }
    }
    return out;
}

std::string toJson(const RayTree& tree, const trace::World& world) {
    checkTree(tree, world);
    nlohmann::json j = {{"pixel", {tree.name.x, tree.name.y}},
                        {"sample", tree.name.index},
                        {"radiance", json(tree.radiance)},
                        {"nodes", nlohmann::json::array()},
                        {"shadow_rays", nlohmann::json::array()}};
    for (const RayNode& node : tree.nodes) j["nodes"].push_back(nodeJson(node, world));
    for (const ShadowRay& ray : tree.shadowRays)
        j["shadow_rays"].push_back({{"node", ray.node},
                                    {"light", ray.light},
                                    {"sample", ray.sample},
                                    {"from", json(ray.from)},
                                    {"to", json(ray.to)},
                                    {"color", json(ray.color)},
                                    {"visibility", probe::nameOf(ray.visibility)},
                                    {"contribution", json(ray.contribution)}});
    return j.dump(2) + "\n";
}

std::string toObj(const RayTree& tree, float missLength) {
    std::string out =
        fmt::format("# rays of pixel {},{} sample {}\n", tree.name.x, tree.name.y, tree.name.index);
    int vertices = 0;
    std::string_view group;
    const auto line = [&](std::string_view kind, const glm::vec3& from, const glm::vec3& to) {
        if (kind != group) out += fmt::format("g {}\n", groupName(group = kind));
        out += fmt::format("v {} {} {}\nv {} {} {}\nl {} {}\n", from.x, from.y, from.z, to.x, to.y, to.z,
                           vertices + 1, vertices + 2);
        vertices += 2;
    };
    for (const RayNode& node : tree.nodes)
        line(node.hit ? probe::nameOf(node.kind) : probe::nameOf(node.end), node.ray.origin,
             endOf(node, missLength));
    for (const ShadowRay& ray : tree.shadowRays) line(probe::nameOf(ray.visibility), ray.from, ray.to);
    return out;
}

}  // namespace rayscope
