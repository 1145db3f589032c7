#pragma once
#include <rayscope/path.h>
#include <rayscope/ray.h>
#include <rayscope/render_session.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rayscope {

/// A segment of the path tree and the surface that it met.
struct RayNode {
    int parent = -1;  ///< index into RayTree::nodes; -1 for camera rays
    RayKind kind = RayKind::Camera;
    int depth = 0;  ///< reflections before this segment
    Ray ray;
    glm::dvec3 throughput{1.0};  ///< what the radiance along this segment is multiplied with
    bool hit = false;
    Hit primitiveHit;  ///< t, primitive, u, v
    int object = -1;   ///< mesh or sphere number: meshes first
    int material = -1;
    double opacity = 1.0;  ///< of that material
    glm::vec2 uv{0.0f};    ///< texture coordinates; 0 where the surface has no texture
    glm::vec3 position{0.0f}, geometricNormal{0.0f}, normal{0.0f};
    Rgb kd{0.0f};
    RgbSum contribution{0.0};  ///< sum of what this vertex added to the sample's radiance
    RayEnd end = RayEnd::Missed;
};

/// A ray from a surface to a position on a light.
struct ShadowRay {
    int node = 0;  ///< the vertex it belongs to
    int light = 0, sample = 0;
    glm::vec3 from{0.0f}, to{0.0f};
    Ray ray;          ///< as it was traced; t = 1 is the light
    Rgb color{0.0f};  ///< of the light there
    Visibility visibility = Visibility::Visible;
    RgbSum contribution{0.0};
};

/// All rays of one sample, in the order in which they were traced.
struct RayTree {
    SampleId name;
    float time = 0.0f;  ///< of the shutter, 0 … 1
    std::vector<RayNode> nodes;
    std::vector<ShadowRay> shadowRays;
    std::vector<RgbSum> addends;  ///< their left fold is `radiance`, bit for bit
    RgbSum radiance{0.0};
};

/// Traces one sample again with a recorder. Same code, same bits as the render.
RayTree probeSample(const trace::World& world, std::uint64_t seed, SampleId name);

/// The radiance that arrives along each segment of the tree: what it and everything after it adds to the
/// sample, divided by its throughput (0 where that is 0). Indexed like `nodes`.
std::vector<RgbSum> radianceAlong(const RayTree& tree);

/// What the surface at the end of a segment shows of its own, undimmed by its opacity; where nothing was hit,
/// what the environment shows.
RgbSum surfaceColor(const RayNode& node);

/// Where in the image a sample lies: pixel coordinates, x to the right, y downwards.
glm::dvec2 samplePosition(const trace::World& world, std::uint64_t seed, SampleId name);

/// Whether replaying a pixel gives what the film holds, and whether each tree adds up.
struct ReplayResult {
    bool matchesFilm = false, sumMatches = false;
    RgbSum film{0.0}, replayed{0.0};
    int samples = 0;
    std::vector<RgbSum> values;  ///< of the samples
    bool good() const { return matchesFilm && sumMatches; }
};
/// `beforeSample`, if given, is called before each sample and may throw to stop.
ReplayResult verifyReplay(const trace::World& world, const render::Film& film, std::uint64_t seed, int x,
                          int y, const std::function<void()>& beforeSample = {});

/// The tree as an indented text for people, and as JSON for programs.
std::string toText(const RayTree& tree, const trace::World& world);
std::string toJson(const RayTree& tree, const trace::World& world);

/// The rays as line segments of a Wavefront OBJ, one group per kind; rays that miss are `missLength` long.
std::string toObj(const RayTree& tree, float missLength);

}  // namespace rayscope
