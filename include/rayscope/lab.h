#pragma once
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

/// What is compared: the tracer as it is, and the usual alternatives, which exist in the laboratory only.
enum class LabMethod {
    Rayscope,  ///< the hierarchy and its kernels, hit points and starts of rays as in a picture
    Float,     ///< Möller and Trumbore 1997 in float, no tolerance
    Epsilon,   ///< the same with fixed tolerances of 1e-6, for the determinant and the least t
    Double     ///< the same in double, no tolerance
};
inline constexpr std::array kLabMethods{LabMethod::Rayscope, LabMethod::Float, LabMethod::Epsilon,
                                        LabMethod::Double};
struct LabMethodInfo {
    const char* name;   ///< one word
    const char* label;  ///< a few
};
const LabMethodInfo& infoOf(LabMethod method);

enum class LabFailureKind { Leak, DoubleHit, FalseHit, LostSurface, Inaccurate };
const char* nameOf(LabFailureKind fault);

/// What happened to the rays of one testPoint with one method. Whether a ray should hit is decided by exact
/// arithmetic on the mesh as its floats are.
struct LabCounts {
    /// Rays at shared edges and vertices that cross the triangles around them; those that crossed nothing,
    /// and those that crossed an even number of them.
    std::uint64_t sharedEdgeRays = 0, leaks = 0, doubleHits = 0;
    /// Rays that leave a surface; those that hit it, or what lies behind it. The first method also counts
    /// hits of triangles that the ray passes beside.
    std::uint64_t spawned = 0, falseHits = 0;
    /// Rays that leave a surface towards another one, at least eight error bounds away; those that miss it.
    std::uint64_t offsetSurfaceRays = 0, missedSurfaces = 0;
    /// Largest errors, of t and of the barycentric weights, over the bound that the tracer promises.
    double tRatio = 0.0, weightRatio = 0.0;

    bool passed() const {
        return leaks + doubleHits + falseHits + missedSurfaces == 0 && tRatio <= 1.0 && weightRatio <= 1.0;
    }
};

/// The mesh scaled by 2^scale and then moved away from the origin by `offset` times its size.
struct LabTransform {
    int scale = 0;
    double offset = 0.0;
};

struct LabTestPoint {
    LabTransform transform;
    std::array<LabCounts, kLabMethods.size()> methods;
    std::uint64_t degenerate =
        0;  ///< triangles that have no area any more: their corners became one point or line
    std::uint64_t undecided = 0;  ///< rays too near to the rim of what they aim at to expect anything

    const LabCounts& of(LabMethod method) const { return methods[static_cast<std::size_t>(method)]; }
};

/// A ray that went wrong, in the coordinates of its testPoint.
struct LabFailure {
    std::size_t testPoint = 0;
    LabMethod method = LabMethod::Rayscope;
    LabFailureKind fault = LabFailureKind::Leak;
    Ray ray;
};

/// Where a method makes no mistake, among the testPoints that were measured: scales at offset 0 without a gap
/// around 2^0, and offsets at scale 2^0 without a gap from 0.
struct LabRange {
    bool soundUntransformed =
        false;  ///< in the testPoint of scale 2^0 and offset 0; if not, the rest says nothing
    int lowestScale = 0, highestScale = 0;
    double largestOffset = 0.0;
    /// The next steps, if they fail; without them the range ends where measuring did.
    std::optional<int> failsBelow, failsAbove;
    std::optional<double> failsBeyond;
    std::uint64_t failingTestPoints = 0;  ///< of all
};

struct LabResult {
    std::string scene;
    std::size_t triangles = 0, sharedEdges = 0, closedVertices = 0, spheres = 0;
    double size = 0.0;    ///< diagonal of the bounds, in scene units
    double offset = 0.0;  ///< of the scene as it is: distance of its centre from the origin, in sizes
    glm::dvec3 center{0.0};
    int raysPerTestPoint = 0;
    std::vector<LabTestPoint> testPoints;  ///< by scale, then by offset
    std::vector<LabFailure> failures;      ///< some of each testPoint, method and fault
    std::array<LabRange, kLabMethods.size()> ranges;
    double meshOffset = 0.0;  ///< largest measured offset at scale 2^0 at which no triangle has degenerate
    std::vector<std::string> remarks;
    double seconds = 0.0;
    bool interrupted = false;

    /// Counts of all testPoints together, and the worst of their ratios.
    LabCounts total(LabMethod method) const;
    const LabRange& range(LabMethod method) const { return ranges[static_cast<std::size_t>(method)]; }
};

struct LabRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;            ///< those of the hierarchy and its kernels count
    int raysPerTestPoint = 2000;  ///< rays at edges and vertices; half as many leave surfaces
    bool quick = false;           ///< a coarse grid of places
    std::uint64_t seed = 0;
    int threads = 0;  ///< 0: one per core
    std::function<void(double fraction, double remainingSeconds)> progress;
    std::stop_token stop;
};

/// Puts the triangles of a scene through scales and offsets. A stop leaves what was measured until then.
/// Throws InputError for a scene without triangles. The counts are a function of the request alone.
LabResult runLab(const LabRequest& request);

/// Closed and open shapes made by formula, for a laboratory without a scene.
SceneDescription labShapes();

/// The triangles of a scene as they stand in a testPoint, for looking at its failures and casting them again.
MeshData meshAt(const SceneDescription& scene, const LabTransform& transform);

/// A failing ray in the coordinates of the scene as it is, for looking at; rounded.
Ray rayInScene(const LabResult& result, const LabFailure& failure);

std::string labJson(const LabResult& result);
std::string labCsv(const LabResult& result);
std::string labText(const LabResult& result);
/// One page with charts, which needs no other file.
std::string labHtml(const LabResult& result);

/// Writes lab.json, lab.csv and lab.html into a folder, and of the first failing testPoint of each method the
/// mesh as NAME.obj and its failing rays as NAME.rays, ready for `rayscope cast`. Returns the commands that
/// do so.
std::vector<std::string> writeLab(const LabResult& result, const SceneDescription& scene,
                                  const std::string& folder);

}  // namespace rayscope
