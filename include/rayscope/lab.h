#pragma once
// Numerical robustness of ray-triangle intersection, measured against exact arithmetic.
#include <rayscope/ray.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace rayscope {

/// The methods that are compared: the tracer, and three textbook triangle tests as controls.
enum class LabMethod {
    Rayscope,  ///< BVH, kernels, hit points and ray origins of the tracer
    Float,     ///< Möller and Trumbore 1997 in float, no tolerance
    Epsilon,   ///< the same with a tolerance of 1e-6 for the determinant and for the least t
    Double     ///< the same in double, no tolerance
};
inline constexpr std::array kLabMethods{LabMethod::Rayscope, LabMethod::Float, LabMethod::Epsilon,
                                        LabMethod::Double};
struct LabMethodInfo {
    const char* name;   ///< key in JSON and CSV, one word
    const char* label;  ///< for people
};
const LabMethodInfo& infoOf(LabMethod method);

enum class LabFailureKind { Leak, DoubleHit, FalseHit, LostSurface, Inaccurate };
const char* nameOf(LabFailureKind kind);

/// Rays and failures of one method at one test point. Exact arithmetic on the float coordinates of the mesh
/// decides which rays must hit.
struct LabCounts {
    /// Rays aimed at shared edges and vertices.
    std::uint64_t sharedEdgeRays = 0;
    std::uint64_t leaks = 0;       ///< of them, rays that hit none of the triangles around the edge or vertex
    std::uint64_t doubleHits = 0;  ///< of them, rays that hit an even number of these triangles
    /// Spawned rays.
    std::uint64_t spawned = 0;
    /// Spawned rays that hit the surface they start on, or one behind it. For LabMethod::Rayscope also hits
    /// of triangles that the ray misses.
    std::uint64_t falseHits = 0;
    /// Spawned rays towards a second surface at a distance of at least eight error bounds.
    std::uint64_t offsetSurfaceRays = 0;
    std::uint64_t missedSurfaces = 0;  ///< of them, rays that miss it
    /// Largest errors of t and of the barycentric weights, divided by the tracer's error bounds.
    double tRatio = 0.0, weightRatio = 0.0;

    bool passed() const {
        return leaks + doubleHits + falseHits + missedSurfaces == 0 && tRatio <= 1.0 && weightRatio <= 1.0;
    }
};

/// Scales the mesh about its centre by 2^scale and moves it to a distance of `offset` times its size from the
/// origin.
struct LabTransform {
    int scale = 0;
    double offset = 0.0;
};

struct LabTestPoint {
    LabTransform transform;
    std::array<LabCounts, kLabMethods.size()> methods;
    /// Triangles that lost their area when their vertices were rounded to float.
    std::uint64_t degenerate = 0;
    /// Rays that pass the boundary of their target within rounding error, so that hit and miss are both
    /// correct.
    std::uint64_t undecided = 0;

    const LabCounts& of(LabMethod method) const { return methods[static_cast<std::size_t>(method)]; }
};

/// A ray with a wrong result, in the coordinates of its test point.
struct LabFailure {
    std::size_t testPoint = 0;  ///< index into LabResult::testPoints
    LabMethod method = LabMethod::Rayscope;
    LabFailureKind kind = LabFailureKind::Leak;
    Ray ray;
};

/// The contiguous range of test points around scale 2^0 and offset 0 at which a method passes: over scales at
/// offset 0, and over offsets at scale 2^0.
struct LabRange {
    /// Whether the method passes at scale 2^0 and offset 0. If not, the members below are meaningless.
    bool soundUntransformed = false;
    int lowestScale = 0, highestScale = 0;
    double largestOffset = 0.0;
    /// The first failing test point beyond each end; empty where the range ends with the measured grid.
    std::optional<int> failsBelow, failsAbove;
    std::optional<double> failsBeyond;
    std::uint64_t failingTestPoints = 0;  ///< over the whole grid
};

struct LabResult {
    std::string scene;
    std::size_t triangles = 0, sharedEdges = 0, closedVertices = 0, spheres = 0;
    double size = 0.0;    ///< diagonal of the bounds, in scene units
    double offset = 0.0;  ///< of the untransformed scene: distance of its centre from the origin, in sizes
    glm::dvec3 center{0.0};
    int raysPerTestPoint = 0;
    std::vector<LabTestPoint> testPoints;  ///< by scale, then by offset
    std::vector<LabFailure> failures;      ///< at most 12 per test point, method and kind
    std::array<LabRange, kLabMethods.size()> ranges;
    double meshOffset = 0.0;  ///< largest measured offset at scale 2^0 without degenerate triangles
    std::vector<std::string> remarks;
    double seconds = 0.0;
    bool interrupted = false;

    /// Sums of the counts over all test points, and the largest ratios.
    LabCounts total(LabMethod method) const;
    const LabRange& range(LabMethod method) const { return ranges[static_cast<std::size_t>(method)]; }
};

struct LabRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;            ///< only those of the BVH and its kernels are used
    int raysPerTestPoint = 2000;  ///< rays at edges and vertices; half as many spawned rays are added
    bool quick = false;           ///< a coarse grid of scales and offsets
    std::uint64_t seed = 0;
    int threads = 0;  ///< 0: one per core
    std::function<void(double fraction, double remainingSeconds)> progress;
    std::stop_token stop;
};

/// Tests the triangles of a scene at a grid of scales and offsets. After a stop request the result holds the
/// test points that were finished. Throws InputError for a scene without triangles. The counts are a pure
/// function of the request.
LabResult runLab(const LabRequest& request);

/// Generated closed and open meshes, for a run without a scene.
SceneDescription labShapes();

/// The triangles of a scene with the vertices of a test point.
MeshData meshAt(const SceneDescription& scene, const LabTransform& transform);

/// A failing ray in the coordinates of the untransformed scene, rounded; for display.
Ray rayInScene(const LabResult& result, const LabFailure& failure);

std::string labJson(const LabResult& result);
std::string labCsv(const LabResult& result);
std::string labText(const LabResult& result);
/// A page with charts in one file.
std::string labHtml(const LabResult& result);

/// Writes lab.json, lab.csv and lab.html into a folder. For each method also the mesh (NAME.obj) and the
/// failing rays (NAME.rays) of the failing test point nearest to the untransformed scene. Returns the
/// `rayscope cast` commands that trace these rays.
std::vector<std::string> writeLab(const LabResult& result, const SceneDescription& scene,
                                  const std::string& folder);

}  // namespace rayscope
