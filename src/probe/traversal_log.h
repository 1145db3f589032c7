#pragma once
// The search of one ray through one hierarchy, step by step. The log speaks of boxes and primitives only, so
// that it can tell of trees of any width; a recorder per layout writes it.
#include <rayscope/ray.h>
#include <rayscope/settings.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <string>
#include <vector>

namespace rayscope::trace {
class World;
}

namespace rayscope::probe {

enum class TraversalEvent {
    Visited,  ///< the box is searched now
    Pushed,   ///< the box was hit and goes onto the stack
    Culled,   ///< the box was hit, but begins behind the closest hit found since
    Missed,   ///< the ray does not meet the box
    Hit,      ///< a primitive was tested and becomes the closest hit
    NoHit,    ///< a primitive was tested in vain
    Filtered  ///< the quick test of all triangles of a leaf at once ruled the primitive out
};

/// One step. Distances are in units of the ray's direction.
struct TraversalStep {
    TraversalEvent event = TraversalEvent::Visited;
    std::uint32_t number =
        0;           ///< of a box: index into TraversalLog::boxes; else of the primitive in its motionGroup
    float t = 0.0f;  ///< where the ray enters the box or hits the primitive; NaN where it does not
    float bound = 0.0f;  ///< upper end of the interval in which hits still count, before the step
};

/// A box as far as it was looked at.
struct TraversalBox {
    std::uint32_t node = 0;  ///< its number in the hierarchy; leaves of the wide layout count by themselves
    int parent = -1;         ///< index into TraversalLog::boxes
    bool leaf = false;
    glm::vec3 lower{0.0f}, upper{0.0f};
};

struct TraversalLog {
    std::size_t motionGroup = 0;  ///< of the world
    Ray ray;                      ///< in the frame in which the motionGroup rests …
    glm::vec3 shift{0.0f};        ///< … which is this far from where the motionGroup is at the ray's time
    bool anyHit = false;          ///< the search may end at the first hit, as for shadow rays
    BvhLayout layout = BvhLayout::Binary;  ///< of the tree that was searched
    std::vector<TraversalBox> boxes;
    std::vector<TraversalStep> steps;
    Hit hit;  ///< what the search found; `primitive` counts within the motionGroup

    std::size_t count(TraversalEvent event) const;
    /// Primitives tested exactly.
    std::size_t tests() const { return count(TraversalEvent::Hit) + count(TraversalEvent::NoHit); }
};

/// The search as it stands after a number of steps.
struct TraversalState {
    struct StackEntry {
        std::uint32_t box;
        float t;
    };
    int current = -1;               ///< box that is being searched; -1 before the first
    std::vector<StackEntry> stack;  ///< the next one last
    float bound = 0.0f;
    std::uint32_t closest = kNoPrimitive;
};
void advance(TraversalState& state, const TraversalStep& step);
TraversalState stateAfter(const TraversalLog& log, std::size_t steps);

/// The search for the closest hit in every motionGroup of the world, at the given time of the shutter: the
/// walk that World::closestHit takes through a tree of this layout, watched. Nothing if the BVH is off, or if
/// there is no tree of this layout.
///
/// The wide tree is walked by the portable kernel. Kernels of other instruction sets round distances to boxes
/// otherwise, and may enter a box more or less where a ray passes along its side; their hits are the same.
std::vector<TraversalLog> recordClosestHit(const trace::World& world, const Ray& ray, float time,
                                           BvhLayout layout = BvhLayout::Binary);
/// The search for any hit, as shadow rays do it; motionGroups after the first hit are not searched.
std::vector<TraversalLog> recordAnyHit(const trace::World& world, const Ray& ray, float time,
                                       BvhLayout layout = BvhLayout::Binary);

/// "enters node 12".
std::string describe(const TraversalLog& log, const TraversalStep& step);
/// How much of everything happened, in one line.
std::string summary(const TraversalLog& log);
/// One line per step, with the interval and the stack; and the same as JSON.
std::string toText(const TraversalLog& log);
std::string toJson(const TraversalLog& log);

}  // namespace rayscope::probe
