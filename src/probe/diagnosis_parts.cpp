#include "probe/diagnosis_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "probe/surface_report.h"
#include "probe/traversal_log.h"
#include "probe/tree_index.h"

namespace rayscope::probe {

PixelEvidence gatherEvidence(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                             const std::function<void()>& beforeSample, const std::stop_token& stop) {
    PixelEvidence pixel{world, seed, {}, {}};
    std::vector<RgbSum> values;
    for (int index = 0; index < samples; ++index) {
        if (beforeSample) beforeSample();
        pixel.trees.push_back(probeSample(world, seed, {x, y, index}, stop));
        values.push_back(pixel.trees.back().radiance);
    }
    pixel.statistics = statisticsOf(values);
    return pixel;
}

std::string locationText(const trace::World& world, std::uint32_t primitive) {
    const trace::PrimitiveLocation name = world.locatePrimitive(primitive);
    const std::string object = objectName(world, static_cast<int>(name.range->object));
    return name.range->mesh ? fmt::format("triangle {} of {}", name.inObject, object) : object;
}

double normalDeviation(const trace::World& world, const RayNode& node, float time) {
    const auto normals = vertexNormalsOf(world, node, time);
    if (!normals || !world.settings.normalInterpolation) return 0.0;
    const glm::dvec3 a(normals->position[0]), b(normals->position[1]), c(normals->position[2]);
    const glm::dvec3 own = glm::normalize(glm::cross(b - a, c - a));
    double cosines[3];
    for (int i = 0; i < 3; ++i) cosines[i] = glm::dot(own, glm::dvec3(normals->normal[i]));
    // The winding may be opposite to the normals.
    const double sign = cosines[0] + cosines[1] + cosines[2] < 0.0 ? -1.0 : 1.0;
    double worst = 0.0;
    for (const double cosine : cosines) {
        if (!std::isfinite(cosine)) return cosine;
        worst = std::max(worst, glm::degrees(std::acos(std::clamp(sign * cosine, -1.0, 1.0))));
    }
    return worst;
}

namespace {

/// The corners of a triangle, sorted so that the winding does not matter; the center and radius of a sphere.
std::array<glm::vec3, 3> cornersOf(const AccelInput& input, std::uint32_t primitive) {
    if (primitive >= input.triangles.size()) {
        const Sphere& sphere = input.spheres[primitive - input.triangles.size()];
        return {sphere.center, glm::vec3(sphere.radius), glm::vec3(0.0f)};
    }
    const glm::uvec3& index = input.triangles[primitive];
    std::array<glm::vec3, 3> corners{input.vertices[index.x], input.vertices[index.y],
                                     input.vertices[index.z]};
    std::sort(corners.begin(), corners.end(), [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return corners;
}

}  // namespace

std::uint32_t findDuplicateAlong(const trace::World& world, const Ray& ray, float time) {
    for (const TraversalLog& log : recordClosestHit(world, ray, time)) {
        const trace::MotionGroup& motionGroup = world.motionGroups[log.motionGroup];
        std::vector<std::uint32_t> primitives;  // duplicates need not share a leaf
        for (const TraversalBox& box : log.boxes) {
            if (!box.leaf) continue;
            const auto held = primitivesOfLeaf(*motionGroup.accel->binaryTree(), box.node);
            primitives.insert(primitives.end(), held.begin(), held.end());
        }
        for (std::size_t i = 0; i < primitives.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (cornersOf(motionGroup.geometry->input, primitives[i]) ==
                    cornersOf(motionGroup.geometry->input, primitives[j]))
                    return primitives[i] + motionGroup.firstPrimitive;
    }
    return kNoPrimitive;
}

std::optional<Diagnosis> diagnoseNonFinite(const PixelEvidence& pixel) {
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample) {
        const RayTree& tree = pixel.trees[sample];
        if (std::isfinite(pixel.statistics.luminance[sample]) &&
            std::isfinite(static_cast<float>(pixel.statistics.luminance[sample])))
            continue;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const RayNode& node = tree.nodes[i];
            const bool bad = !std::isfinite(
                static_cast<float>(node.contribution.x + node.contribution.y + node.contribution.z));
            if (!bad && i + 1 < tree.nodes.size()) continue;
            Diagnosis why{Symptom::NonFinite,
                          Cause::Unknown,
                          "",
                          {{static_cast<int>(sample), static_cast<int>(i), -1}}};
            const glm::vec3 n = node.normal;
            if (node.hit && (!std::isfinite(n.x + n.y + n.z) ||
                             std::isnan(normalDeviation(pixel.world, node, tree.time)))) {
                why.cause = Cause::BadNormal;
                why.sentence = fmt::format("The shading normal of {} is not a number.",
                                           locationText(pixel.world, node.primitiveHit.primitive));
            } else if (node.hit && (std::isnan(node.kd.r + node.kd.g + node.kd.b))) {
                why.cause = Cause::Unknown;
                why.sentence = fmt::format("The colour of {} is not a number.",
                                           locationText(pixel.world, node.primitiveHit.primitive));
            } else if (std::isinf(static_cast<float>(node.contribution.x + node.contribution.y +
                                                     node.contribution.z)) ||
                       !bad) {
                why.cause = Cause::Overflow;
                why.sentence =
                    "A contribution exceeds the range of float: a light or material is too strong.";
            } else {
                why.sentence = "A contribution is not a number; normal and colour are finite.";
            }
            return why;
        }
    }
    return std::nullopt;
}

}  // namespace rayscope::probe
