#pragma once
#include <rayscope/probe.h>

#include <string_view>

#include "base/memory_budget.h"
#include "trace/path_observer.h"
#include "trace/shadow_ray.h"

namespace rayscope::probe {

/// Records the rays of a sample.
class RayTreeRecorder {
  public:
    RayTreeRecorder(RayTree& tree, const trace::World& world) : tree_(tree), world_(world) {}

    void segment(const trace::Segment& segment) {
        base::requireRoom(tree_.nodes, kWhat, kAdvice);
        RayNode node;
        node.kind = segment.kind;
        node.depth = segment.depth;
        node.ray = segment.ray;
        node.throughput = segment.throughput;
        node.parent = parentOf(segment);
        latestAtDepth_.resize(static_cast<std::size_t>(segment.depth) + 1);
        latestAtDepth_.back() = static_cast<int>(tree_.nodes.size());
        tree_.nodes.push_back(node);
    }
    void hit(const trace::Interaction& at) {
        RayNode& node = tree_.nodes.back();
        node.hit = true;
        node.primitiveHit = at.hit;
        node.object = static_cast<int>(at.object);
        node.material = static_cast<int>(at.material);
        node.opacity = world_.materials[at.material].opacity;
        node.uv = at.uv;
        node.position = glm::vec3(at.position);
        node.geometricNormal = glm::vec3(at.geometricNormal);
        node.normal = glm::vec3(at.normal);
        node.kd = Rgb(at.kd);
    }
    void lightSampled(const trace::LightConnection& light, const glm::dvec3& value) {
        base::requireRoom(tree_.shadowRays, kWhat, kAdvice);
        ShadowRay ray;
        ray.node = static_cast<int>(tree_.nodes.size()) - 1;
        ray.light = light.light;
        ray.sample = light.sample;
        ray.from = light.from;
        ray.to = glm::vec3(light.at.position);
        ray.ray = trace::shadowRay(light.from, light.at.position);
        ray.color = Rgb(light.at.color);
        ray.visibility = light.visibility;
        ray.contribution = value;
        tree_.shadowRays.push_back(ray);
    }
    void added(const glm::dvec3& value) {
        tree_.nodes.back().contribution += value;
        base::requireRoom(tree_.addends, kWhat, kAdvice);
        tree_.addends.push_back(value);
    }
    void ended(const trace::Segment& segment, RayEnd why) {
        tree_.nodes[static_cast<std::size_t>(latestAtDepth_[static_cast<std::size_t>(segment.depth)])].end =
            why;
    }

  private:
    static constexpr std::string_view kWhat = "the ray tree of a sample";
    static constexpr std::string_view kAdvice = "fewer samples of lights, lenses and glossy reflections";

    int parentOf(const trace::Segment& segment) const {
        if (segment.kind == RayKind::Camera) return -1;
        const int depth = segment.kind == RayKind::Transparent ? segment.depth : segment.depth - 1;
        return latestAtDepth_[static_cast<std::size_t>(depth)];
    }

    RayTree& tree_;
    const trace::World& world_;
    std::vector<int> latestAtDepth_;
};
static_assert(trace::PathObserver<RayTreeRecorder>);

}  // namespace rayscope::probe
