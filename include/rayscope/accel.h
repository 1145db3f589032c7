#pragma once
#include <rayscope/ray.h>
#include <rayscope/settings.h>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace rayscope {

/// Geometry of an Accel. The caller keeps the memory alive and unchanged as long as the Accel is used.
struct AccelInput {
    std::span<const glm::vec3> vertices;
    std::span<const glm::uvec3> triangles;
    std::span<const Sphere> spheres;
};

struct BuildSettings {
    BvhBuilder builder = BvhBuilder::SahBinned;
    int bins = 32;                       ///< bins per axis of SahBinned and SahReinsertion, 2 … 4096
    int maxLevel = 64;                   ///< deepest level of the binary tree (the root is 0), 0 … 64
    int leafSize = 4;                    ///< maximum primitives of a leaf above the deepest level, ≥ 1
    BvhLayout layout = BvhLayout::Wide;  ///< of the tree that rays traverse
    Isa isa = Isa::Auto;                 ///< kernels of the wide layout
    bool keepBinaryTree = false;         ///< beside the wide layout, for display
    std::stop_token stop{};              ///< build() throws Stopped within 20 ms of a request
};

namespace bvh {
struct BinaryTree;
struct WideTree;
}  // namespace bvh

/// Size and cost of an Accel.
struct AccelSummary {
    std::size_t binaryNodes = 0;
    int binaryLevels = 0;  ///< including the root
    std::size_t wideNodes = 0, triangleBlocks = 0;
    Isa isa = Isa::Auto;                  ///< of the kernels; Auto: queries traverse the binary tree
    std::uint32_t droppedPrimitives = 0;  ///< left out because of NaN or infinite coordinates
    /// SAH cost of the tree that rays traverse, relative to when it was built; 1 unless refitted.
    double costGrowth = 1.0;
};

/// A bounding volume hierarchy over triangles and spheres. Immutable after build(); all queries may run
/// concurrently. A default-constructed Accel is empty: every ray misses it.
///
/// A hit depends on ray and geometry only: every query returns, of all primitives with the smallest t, the
/// one with the smallest number, for every builder and number of threads. Closed meshes are watertight, and a
/// ray through a shared edge or vertex of a mesh crosses it exactly once.
class Accel {
  public:
    Accel();
    ~Accel();
    Accel(Accel&&) noexcept;
    Accel& operator=(Accel&&) noexcept;

    /// Builds in parallel with the same result for any number of threads. Throws std::invalid_argument if a
    /// triangle names a vertex that does not exist, a setting is out of range or the machine lacks the chosen
    /// instruction set, and std::length_error for more than 2^31 primitives. Primitives with NaN or infinite
    /// coordinates are left out and never hit.
    static Accel build(const AccelInput& input, const BuildSettings& settings = {});

    /// The same tree with new boxes for moved vertices and spheres: a fraction of the time of build() with
    /// the same hits, but more work per ray the farther neighbours have moved apart; see
    /// summary().costGrowth. Rebuilds with the same settings if other primitives than before have NaN or
    /// infinite coordinates. `moved` may be the same memory with new values. Throws std::invalid_argument if
    /// it does not have as many triangles and spheres, or like build().
    Accel refit(const AccelInput& moved, std::stop_token stop = {}) const;

    /// Finds the hit with the smallest t in (tMin, tMax]. Returns false, and leaves `hit` at its default, on
    /// a miss.
    bool closestHit(const Ray& ray, Hit& hit) const;

    /// Whether there is a hit in (tMin, tMax].
    bool anyHit(const Ray& ray) const;

    /// The same results for many rays at once. Throws std::invalid_argument unless both spans have the same
    /// length.
    void closestHits(std::span<const Ray> rays, std::span<Hit> hits) const;
    void anyHits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const;

    /// Replaces `found` with all hits in (tMin, tMax], in order of t and at equal t of the primitive numbers.
    /// A ray that enters and leaves a sphere has two hits with it. A ray through a shared edge or vertex of a
    /// mesh has one hit there if it passes to the other side of the surface, and an even number if it only
    /// touches it, so that the number of crossings of a closed mesh is even for rays that begin outside.
    void crossings(const Ray& ray, std::vector<Hit>& found) const;

    /// The size of the result of crossings().
    std::size_t countCrossings(const Ray& ray) const;

    /// Whether `point` lies inside the surfaces: the parity of the crossings of a ray from it, for closed
    /// meshes and spheres of any orientation. Where closed surfaces overlap, a point inside two of them is
    /// outside. A point on the surface, or as close to it as rounding, may be either. False for an infinite
    /// or NaN coordinate.
    bool contains(const glm::vec3& point) const;

    /// The binary tree; null when empty or not kept.
    const bvh::BinaryTree* binaryTree() const;
    /// The wide tree; null when empty or when queries traverse the binary one.
    const bvh::WideTree* wideTree() const;
    const AccelSummary& summary() const;
    const AccelInput& input() const;
    std::size_t bytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rayscope
