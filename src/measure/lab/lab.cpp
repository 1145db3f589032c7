#include <oneapi/tbb/parallel_for.h>

#include <rayscope/diagnostics.h>
#include <rayscope/lab.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "measure/lab/summary.h"
#include "measure/lab/test_point.h"
#include "measure/statistics/workers.h"
#include "sampling/hash.h"
#include "trace/compile.h"

namespace rayscope::measure {

namespace {

constexpr LabMethodInfo kMethods[kLabMethods.size()] = {{"rayscope", "as Rayscope traces"},
                                                        {"float", "Möller-Trumbore, float"},
                                                        {"epsilon", "Möller-Trumbore, float, 1e-6"},
                                                        {"double", "Möller-Trumbore, double"}};
constexpr const char* kFailureKinds[] = {"leak", "double hit", "false hit", "lost surface", "inaccurate"};

constexpr std::size_t kFailuresKept = 12;  ///< per testPoint, method and fault
constexpr std::size_t kBlock = 256;        ///< rays per task

std::vector<LabTransform> transformsOf(bool quick) {
    std::vector<LabTransform> places;
    for (int scale = -40; scale <= 40; scale += quick ? 20 : 10)
        for (const double offset : {0.0, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7})
            if (!quick || offset == 0.0 || offset == 1e2 || offset == 1e4 || offset == 1e7)
                places.push_back({scale, offset});
    return places;
}

/// From the scene as it is outwards, so that an early end leaves what matters most.
std::vector<std::size_t> orderOf(const std::vector<LabTransform>& places) {
    std::vector<std::size_t> order(places.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto remoteness = [&](std::size_t i) {
        return std::abs(places[i].scale) / 10.0 + std::log10(1.0 + places[i].offset);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return remoteness(i) < remoteness(j); });
    return order;
}

/// A world that holds the moved mesh and nothing else.
std::shared_ptr<const trace::World> worldOf(const LabMesh& mesh, const std::vector<glm::vec3>& vertices,
                                            const LabRequest& request) {
    auto scene = std::make_shared<SceneDescription>();
    auto data = std::make_shared<MeshData>();
    data->positions = vertices;
    data->triangles = mesh.triangles();
    scene->materials.emplace_back();
    scene->meshes.push_back({.name = "mesh", .data = std::move(data), .materials = {0}});
    Settings settings = request.settings;
    settings.motionBlur = false;
    return trace::compile({scene, settings, CameraDescription{}, 1, 1, false}, nullptr, request.stop);
}

LabContext contextOf(const LabMesh& mesh, const trace::World& world, const std::vector<glm::vec3>& vertices,
                     const LabTransform& transform, std::uint64_t seed) {
    glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL);
    for (const glm::vec3& v : vertices) {
        lower = glm::min(lower, glm::dvec3(v));
        upper = glm::max(upper, glm::dvec3(v));
    }
    return {mesh, world, vertices, 0.5 * (lower + upper), std::ldexp(mesh.size(), transform.scale), seed};
}

LabTally runTestPoint(const LabContext& target, int rays, const std::stop_token& stop) {
    const auto sharedEdgeRays = static_cast<std::size_t>(rays), total = sharedEdgeRays + sharedEdgeRays / 2;
    std::vector<LabTally> tallies((total + kBlock - 1) / kBlock);
    oneapi::tbb::parallel_for(std::size_t{0}, tallies.size(), [&](std::size_t block) {
        for (std::size_t i = block * kBlock; i < std::min(total, (block + 1) * kBlock); ++i) {
            if (stop.stop_requested()) return;
            i < sharedEdgeRays ? testWatertightness(target, i, tallies[block])
                               : testSpawnedRay(target, i, tallies[block]);
        }
    });
    if (stop.stop_requested()) throw Stopped();
    LabTally sum;
    for (const LabTally& tally : tallies) sum.add(tally);
    return sum;
}

/// Cells by scale, then by offset; failures name them by their new numbers.
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

void LabTally::fail(LabMethod method, LabFailureKind fault, const Ray& ray) {
    const auto kept = std::count_if(failures.begin(), failures.end(), [&](const LabFailure& f) {
        return f.method == method && f.fault == fault;
    });
    if (static_cast<std::size_t>(kept) < kFailuresKept) failures.push_back({0, method, fault, ray});
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
    for (const LabFailure& failure : other.failures) fail(failure.method, failure.fault, failure.ray);
}

}  // namespace rayscope::measure

namespace rayscope {

using namespace measure;

const LabMethodInfo& infoOf(LabMethod method) { return kMethods[static_cast<int>(method)]; }
const char* nameOf(LabFailureKind fault) { return kFailureKinds[static_cast<int>(fault)]; }

LabResult runLab(const LabRequest& request) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const LabMesh mesh(*request.scene);
    if (mesh.triangles().empty())
        throw InputError("the laboratory needs triangles, and this scene has none", {request.scene->path});

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

    const std::vector<LabTransform> places = transformsOf(request.quick);
    Workers workers(request.threads);
    std::size_t done = 0;
    try {
        for (const std::size_t i : orderOf(places)) {
            if (request.progress) {
                const double fraction = static_cast<double>(done) / static_cast<double>(places.size());
                request.progress(fraction, done == 0 ? 0.0 : elapsed() * (1.0 / fraction - 1.0));
            }
            if (request.stop.stop_requested()) throw Stopped();
            const std::vector<glm::vec3> vertices = mesh.verticesAt(places[i]);
            const auto world = workers.run([&] { return worldOf(mesh, vertices, request); });
            const LabContext target =
                contextOf(mesh, *world, vertices, places[i], sampling::hashPair(request.seed, i));
            LabTally tally =
                workers.run([&] { return runTestPoint(target, request.raysPerTestPoint, request.stop); });
            result.testPoints.push_back(
                {places[i], tally.counts, mesh.degenerate(vertices), tally.undecided});
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
    summarize(result);
    return result;
}

}  // namespace rayscope
