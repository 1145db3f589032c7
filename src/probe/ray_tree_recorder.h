#pragma once
#include <rayscope/probe.h>

#include "trace/path_observer.h"

namespace rayscope {

/// Writes down everything that happens while a sample is traced.
class RayTreeRecorder {
  public:
    explicit RayTreeRecorder(RayTree& tree) : tree_(tree) {}

    void segment(const Segment& segment) {
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
    void hit(const Interaction& at) {
        RayNode& node = tree_.nodes.back();
        node.hit = true;
        node.primitiveHit = at.hit;
        node.object = static_cast<int>(at.object);
        node.material = static_cast<int>(at.material);
        node.position = glm::vec3(at.position);
        node.geometricNormal = glm::vec3(at.geometricNormal);
        node.normal = glm::vec3(at.normal);
        node.kd = Rgb(at.kd);
    }
    void lightSampled(const LightConnection& light, const glm::dvec3& value) {
        tree_.shadowRays.push_back({static_cast<int>(tree_.nodes.size()) - 1, light.light, light.sample,
                                    light.from, glm::vec3(light.at.position), Rgb(light.at.color),
                                    light.visibility, value});
    }
    void added(const glm::dvec3& value) {
        tree_.nodes.back().contribution += value;
        tree_.addends.push_back(value);
    }
    void ended(const Segment& segment, RayEnd why) {
        tree_.nodes[static_cast<std::size_t>(latestAtDepth_[static_cast<std::size_t>(segment.depth)])].end =
            why;
    }

  private:
    int parentOf(const Segment& segment) const {
        if (segment.kind == RayKind::Camera) return -1;
        const int depth = segment.kind == RayKind::Transparent ? segment.depth : segment.depth - 1;
        return latestAtDepth_[static_cast<std::size_t>(depth)];
    }

    RayTree& tree_;
    std::vector<int> latestAtDepth_;
};
static_assert(PathObserver<RayTreeRecorder>);

}  // namespace rayscope
