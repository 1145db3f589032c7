#pragma once
#include <rayscope/path.h>
#include <rayscope/ray.h>
#include <rayscope/render_session.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// A segment of a path and the surface that it hit.
struct RayNode {
    int parent = -1;  ///< index into RayTree::nodes; -1 for camera rays
    RayKind kind = RayKind::Camera;
    int depth = 0;  ///< reflections before this segment
    Ray ray;
    glm::dvec3 throughput{1.0};  ///< factor of the radiance along this segment
    bool hit = false;
    Hit primitiveHit;  ///< t, primitive, u, v
    int object = -1;   ///< mesh or sphere number: meshes first
    int material = -1;
    double opacity = 1.0;  ///< of that material
    glm::vec2 uv{0.0f};    ///< texture coordinates; 0 where the surface has no texture
    glm::vec3 position{0.0f}, geometricNormal{0.0f}, normal{0.0f};
    Rgb kd{0.0f};
    RgbSum contribution{0.0};  ///< of this vertex to the radiance of the sample
    RayEnd end = RayEnd::Missed;
};

/// A ray from a surface to a light sample.
struct ShadowRay {
    int node = 0;  ///< index of the vertex in RayTree::nodes
    int light = 0, sample = 0;
    glm::vec3 from{0.0f}, to{0.0f};
    Ray ray;          ///< as traced; t = 1 is the light
    Rgb color{0.0f};  ///< of the light sample
    Visibility visibility = Visibility::Visible;
    RgbSum contribution{0.0};
};

/// "reflection", "depth limit", "occluded" …
std::string_view nameOf(RayKind kind);
std::string_view nameOf(RayEnd end);
std::string_view nameOf(Visibility visibility);

/// "mesh 0 'dragon'" or "sphere 2 'bulb'": the object with this number, see RayNode::object.
std::string objectName(const trace::World& world, int object);

/// All rays of one sample in tracing order.
struct RayTree {
    SampleId name;
    float time = 0.0f;  ///< of the shutter, 0 … 1
    std::vector<RayNode> nodes;
    std::vector<ShadowRay> shadowRays;
    std::vector<RgbSum> addends;  ///< their sum from left to right is `radiance`, bit for bit
    RgbSum radiance{0.0};
};

/// Traces one sample again with a recorder: the code of the render, with the same bits. Throws Stopped
/// (diagnostics.h) on a stop request, and OutOfMemory (memory.h) for a sample with too many rays.
RayTree probeSample(const trace::World& world, std::uint64_t seed, SampleId name,
                    const std::stop_token& stop = {});

/// The radiance along each segment of the tree: the contributions of its vertex and all later ones, divided
/// by its throughput (0 where that is 0). Indexed like `nodes`.
std::vector<RgbSum> radianceAlong(const RayTree& tree);

/// The radiance of the surface at the end of a segment without its opacity, or of the environment on a miss.
RgbSum surfaceColor(const RayNode& node);

/// The position of a sample in the image: pixel coordinates, x to the right, y downwards.
glm::dvec2 samplePosition(const trace::World& world, std::uint64_t seed, SampleId name);

/// Whether the replay of a pixel equals the film bit for bit, and whether the addends of each tree sum up to
/// its radiance.
struct ReplayResult {
    bool matchesFilm = false, sumMatches = false;
    RgbSum film{0.0}, replayed{0.0};
    int samples = 0;
    std::vector<RgbSum> values;  ///< of the samples
    bool good() const { return matchesFilm && sumMatches; }
};
/// `beforeSample`, if given, is called before each sample and may throw to stop. `stop` is checked within
/// samples, too, and throws Stopped.
ReplayResult verifyReplay(const trace::World& world, const render::Film& film, std::uint64_t seed, int x,
                          int y, const std::function<void()>& beforeSample = {},
                          const std::stop_token& stop = {});

/// The tree as indented text and as JSON.
std::string toText(const RayTree& tree, const trace::World& world);
std::string toJson(const RayTree& tree, const trace::World& world);

/// The rays as line segments of a Wavefront OBJ, one group per kind; rays that miss are `missLength` long.
std::string toObj(const RayTree& tree, float missLength);

/// Writes toJson() or toObj(), by the suffix .json or .obj. Replaces an existing file atomically. Throws
/// InputError if the suffix is another or the file cannot be written.
void writeRayTree(const std::string& path, const RayTree& tree, const trace::World& world, float missLength);

}  // namespace rayscope
