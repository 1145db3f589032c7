#pragma once
#include <rayscope/vector.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/mesh_files/geometry/point_tree.h"

namespace rayscope::scene {

/// Ear clipping of a polygon of any number of corners. A corner is tested when the queue of corners reaches
/// it, and again after a neighbour was clipped: at most three tests per corner. In a polygon that does not
/// cross itself nothing else makes a corner an ear. A test takes O(log n) for compact triangles and up to
/// O(√n) for needles across the whole polygon.
class EarClipper {
  public:
    /// `outline`: at least three corners, counter-clockwise; it must outlive the clipper.
    explicit EarClipper(const std::vector<glm::dvec2>& outline);

    /// Fills `triangles`, of outline.size() − 2 elements. False if the polygon crosses itself. `progress` is
    /// called with the number of triangles so far.
    bool clip(std::span<glm::uvec3> triangles, const std::function<void(std::size_t)>& progress);

  private:
    /// How exactly a corner must be an ear.
    enum class Rule {
        Strict,  ///< no other corner in or on its triangle, which has an area
        Lenient  ///< no other corner inside its triangle, which may have no area: spikes, touching edges
    };
    void enqueue(std::uint32_t corner);
    void enqueueAll();
    bool isEar(std::uint32_t corner, Rule rule) const;
    void cut(std::uint32_t corner, std::span<glm::uvec3> triangles);
    /// Cuts ears until no queued corner is one.
    void cutEars(Rule rule, std::span<glm::uvec3> triangles,
                 const std::function<void(std::size_t)>& progress);
    void buildTree();

    const std::vector<glm::dvec2>& flat_;
    std::vector<std::uint32_t> prev_, next_;  ///< links of the corners that are left
    std::vector<std::uint32_t> queue_;
    std::vector<std::size_t> queuedAt_;  ///< per corner: its valid position in the queue
    std::size_t head_ = 0, left_, inTree_ = 0, cut_ = 0;
    std::uint32_t start_ = 0;  ///< a corner that is left
    PointTree tree_;           ///< of the corners that are left
};

}  // namespace rayscope::scene
