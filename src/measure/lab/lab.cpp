#include <oneapi/tbb/parallel_for.h>

#include <rayscope/diagnostics.h>
#include <rayscope/lab.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/check_argument.h"
#include "measure/lab/lab_summary.h"
#include "measure/lab/test_point.h"
#include "render/thread_arena.h"
#include "sampling/hash.h"
#include "trace/compile.h"

namespace rayscope::measure {

namespace {

constexpr LabMethodInfo kMethods[kLabMethods.size()] = {{"rayscope", "Rayscope"},
                                                        {"float", "Möller-Trumbore, float"},
                                                        {"epsilon", "Möller-Trumbore, float, 1e-6"},
                                                        {"double", "Möller-Trumbore, double"}};
constexpr const char* kFailureKinds[] = {"leak", "double hit", "false hit", "lost surface", "inaccurate"};

constexpr std::size_t kFailuresKept = 12;  ///< per test point, method and kind
constexpr std::size_t kBlock = 256;        ///< rays per task

std::vector<LabTransform> transformsOf(bool quick) {
    std::vector<LabTransform> transforms;
    for (int scale = -40; scale <= 40; scale += quick ? 20 : 10)
        for (const double offset : {0.0, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7})
            if (!quick || offset == 0.0 || offset == 1e2 || offset == 1e4 || offset == 1e7)
                transforms.push_back({scale, offset});
    return transforms;
}

/// By distance from the untransformed scene, so that an interrupted run has the most relevant test points.
std::vector<std::size_t> orderOf(const std::vector<LabTransform>& transforms) {
    std::vector<std::size_t> order(transforms.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto distanceFromOriginal = [&](std::size_t i) {
        return std::abs(transforms[i].scale) / 10.0 + std::log10(1.0 + transforms[i].offset);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return distanceFromOriginal(i) < distanceFromOriginal(j);
    });
    return order;
}

LabTally runTestPoint(const LabContext& context, int rays, const std::stop_token& stop) {
    const auto sharedEdgeRays = static_cast<std::size_t>(rays), total = sharedEdgeRays + sharedEdgeRays / 2;
    std::vector<LabTally> tallies((total + kBlock - 1) / kBlock);
    oneapi::tbb::parallel_for(std::size_t{0}, tallies.size(), [&](std::size_t block) {
        for (std::size_t i = block * kBlock; i < std::min(total, (block + 1) * kBlock); ++i) {
            if (stop.stop_requested()) return;
            i < sharedEdgeRays ? testWatertightness(context, i, tallies[block])
                               : testSpawnedRay(context, i, tallies[block]);
        }
    });
    if (stop.stop_requested()) throw Stopped();
    LabTally sum;
    for (const LabTally& tally : tallies) sum.add(tally);
    return sum;
}

/// Sorts test points by scale, then by offset, and updates the indices in the failures.
void sortTestPoints(LabResult& result) {
    std::vector<std::size_t> order(result.testPoints.size()), number(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const LabTransform &a = result.testPoints[i].transform, &b = result.testPoints[j].transform;
        return a.scale != b.scale ? a.scale < b.scale : a.offset < b.offset;
    });
    std::vector<LabTestPoint> testPoints;
    for (std::size_t i = 0; i < order.size(); ++i) {
        number[order[i]] = i;
        testPoints.push_back(result.testPoints[order[i]]);
    }
    result.testPoints = std::move(testPoints);
    for (LabFailure& failure : result.failures) failure.testPoint = number[failure.testPoint];
    std::stable_sort(result.failures.begin(), result.failures.end(),
                     [](const LabFailure& a, const LabFailure& b) { return a.testPoint < b.testPoint; });
}

}  // namespace

std::shared_ptr<const trace::World> worldOf(const LabMesh& mesh, const std::vector<glm::vec3>& vertices,
                                            const Settings& settings, const std::stop_token& stop) {
    auto scene = std::make_shared<SceneDescription>();
    auto data = std::make_shared<MeshData>();
    data->positions = vertices;
    data->triangles = mesh.triangles();
    scene->materials.emplace_back();
    scene->meshes.push_back({.name = "mesh", .data = std::move(data), .materials = {0}});
    Settings still = settings;
    still.motionBlur = false;
    return trace::compile({scene, still, CameraDescription{}, 1, 1, false}, nullptr, stop);
}

LabContext contextOf(const LabMesh& mesh, const trace::World& world, const std::vector<glm::vec3>& vertices,
                     double size, std::uint64_t seed) {
    glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL);
    for (const glm::vec3& v : vertices) {
        lower = glm::min(lower, glm::dvec3(v));
        upper = glm::max(upper, glm::dvec3(v));
    }
    return {mesh, world, vertices, 0.5 * (lower + upper), size, seed};
}

void LabTally::fail(LabMethod method, LabFailureKind kind, const Ray& ray) {
    const auto kept = std::count_if(failures.begin(), failures.end(), [&](const LabFailure& f) {
        return f.method == method && f.kind == kind;
    });
    if (static_cast<std::size_t>(kept) < kFailuresKept) failures.push_back({0, method, kind, ray});
}

void LabTally::add(const LabTally& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        LabCounts& mine = counts[i];
        const LabCounts& theirs = other.counts[i];
        mine.sharedEdgeRays += theirs.sharedEdgeRays;
        mine.leaks += theirs.leaks;
        mine.doubleHits += theirs.doubleHits;
        mine.spawned += theirs.spawned;
        mine.falseHits += theirs.falseHits;
        mine.offsetSurfaceRays += theirs.offsetSurfaceRays;
        mine.missedSurfaces += theirs.missedSurfaces;
        mine.tRatio = std::max(mine.tRatio, theirs.tRatio);
        mine.weightRatio = std::max(mine.weightRatio, theirs.weightRatio);
    }
    undecided += other.undecided;
    for (const LabFailure& failure : other.failures) fail(failure.method, failure.kind, failure.ray);
}

}  // namespace rayscope::measure

namespace rayscope {

using namespace measure;

const LabMethodInfo& infoOf(LabMethod method) { return kMethods[static_cast<int>(method)]; }
const char* nameOf(LabFailureKind kind) { return kFailureKinds[static_cast<int>(kind)]; }

LabResult runLab(const LabRequest& request) {
    base::checkArgument(request.scene != nullptr, "scene is null");
    base::checkArgument(request.raysPerTestPoint >= 1, "raysPerTestPoint is {}; expected at least 1",
                        request.raysPerTestPoint);
    checkSettings(request.settings);
    checkDescription(*request.scene);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const LabMesh mesh(*request.scene);
    if (mesh.triangles().empty())
        throw InputError("the robustness test needs triangles, and this scene has none",
                         {request.scene->path});

    LabResult result;
    result.scene = request.scene->path;
    result.triangles = mesh.triangles().size();
    result.sharedEdges = mesh.edges().size();
    result.closedVertices = mesh.closedVertices().size();
    result.spheres = request.scene->spheres.size();
    result.size = mesh.size();
    result.center = mesh.center();
    result.offset = glm::length(mesh.center()) / mesh.size();
    result.raysPerTestPoint = request.raysPerTestPoint;

    const std::vector<LabTransform> transforms = transformsOf(request.quick);
    render::ThreadArena workers(request.threads);
    std::size_t done = 0;
    try {
        for (const std::size_t i : orderOf(transforms)) {
            if (request.progress) {
                const double fraction = static_cast<double>(done) / static_cast<double>(transforms.size());
                request.progress(fraction, done == 0 ? 0.0 : elapsed() * (1.0 / fraction - 1.0));
            }
            if (request.stop.stop_requested()) throw Stopped();
            const std::vector<glm::vec3> vertices = mesh.verticesAt(transforms[i]);
            const auto world =
                workers.run([&] { return worldOf(mesh, vertices, request.settings, request.stop); });
            const LabContext context =
                contextOf(mesh, *world, vertices, std::ldexp(mesh.size(), transforms[i].scale),
                          sampling::hashPair(request.seed, i));
            LabTally tally =
                workers.run([&] { return runTestPoint(context, request.raysPerTestPoint, request.stop); });
            result.testPoints.push_back(
                {transforms[i], tally.counts, mesh.degenerate(vertices), tally.undecided});
            for (LabFailure& failure : tally.failures) {
                failure.testPoint = done;
                result.failures.push_back(failure);
            }
            ++done;
        }
    } catch (const Stopped&) {
        result.interrupted = true;
    }
    result.seconds = elapsed();
    sortTestPoints(result);
    summarizeLab(result);
    return result;
}

}  // namespace rayscope
