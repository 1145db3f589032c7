#pragma once
#include <rayscope/diagnostics.h>
#include <rayscope/image.h>
#include <rayscope/ray.h>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rayscope {

/// A thin lens, for depth of field. Lengths in scene units, all positive.
struct Lens {
    float fNumber = 2.8f;  ///< aperture diameter = focal length / f-number
    float focalLength = 0.05f;
    float focusDistance = 3.0f;  ///< from the lens to the plane in focus
    bool operator==(const Lens&) const = default;
};

/// A perspective camera. Positions in scene units.
struct CameraDescription {
    std::string name = "main";
    glm::vec3 lookFrom{0.0f, 0.0f, 3.0f};
    glm::vec3 lookAt{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};  ///< any length; not parallel to the view
    float fov = 50.0f;               ///< vertical angle of view, degrees, above 0 and below 180
    std::optional<Lens> lens;        ///< none: a pinhole
    bool operator==(const CameraDescription&) const = default;
};

/// The value of a texture at coordinates outside 0 … 1.
enum class TextureWrap { Repeat, Clamp };

struct Texture {
    std::string file;  ///< path, or "generated"
    RgbImage image;    ///< linear
    TextureWrap wrap = TextureWrap::Repeat;
};

/// Phong's reflection model. kd and ks are the fractions of light, 0 … 1, that are reflected diffusely and
/// specularly.
struct Material {
    std::string name;
    Rgb kd{0.8f};
    Rgb ks{0.0f};
    float shininess = 1.0f;                      ///< exponent of the highlight, at least 0
    float opacity = 1.0f;                        ///< 1 is opaque, 0 invisible
    int illum = -1;                              ///< illumination model of MTL, 0 … 10; -1: not given
    std::shared_ptr<const Texture> kdTexture{};  ///< replaces kd
};

/// An indexed triangle mesh, immutable once read. `normals`, `texCoords` and `colors` are empty or have the
/// size of `positions`.
struct MeshData {
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{};
    std::vector<glm::vec2> texCoords{};  ///< (0, 0) is the lower left corner of the image
    std::vector<Rgb> colors{};           ///< linear
    std::vector<glm::uvec3> triangles{};
    std::vector<std::uint16_t> materialSlots{};  ///< per triangle, or empty if all use slot 0
};

/// Scale, then rotation about x, y and z in this order (degrees), then translation; or any affine map.
struct Transform {
    float scale = 1.0f;
    glm::vec3 rotate{0.0f};
    glm::vec3 translate{0.0f};
    std::optional<glm::mat4> matrix;  ///< replaces the other three
    bool operator==(const Transform&) const = default;
    bool isIdentity() const { return *this == Transform{}; }
};
/// Multiplies column vectors from the left.
glm::dmat4 matrixOf(const Transform& transform);

struct MeshInstance {
    std::string name{};
    std::shared_ptr<const MeshData> data{};
    Transform transform{};
    std::vector<std::uint32_t> materials{};  ///< per material slot: index into SceneDescription::materials
    glm::vec3 motion{0.0f};                  ///< displacement while the shutter is open, scene units
    /// The colours of `data`, if it has any, replace kd of the materials and multiply their textures.
    bool vertexColors = false;
};

struct SphereInstance {
    std::string name;
    Sphere sphere;
    std::uint32_t material = 0;  ///< index into SceneDescription::materials
    glm::vec3 motion{0.0f};      ///< displacement while the shutter is open, scene units
    bool operator==(const SphereInstance& o) const {
        return name == o.name && sphere.center == o.sphere.center && sphere.radius == o.sphere.radius &&
               material == o.material && motion == o.motion;
    }
};

/// Attenuation of a light with distance.
enum class Falloff { None, InverseSquare };

struct PointLight {
    glm::vec3 position{0.0f};
    Rgb color{1.0f};
    bool operator==(const PointLight&) const = default;
};

/// A line segment; colours are linear between its endpoints.
struct SegmentLight {
    std::array<glm::vec3, 2> endpoints{glm::vec3(0.0f), glm::vec3(1.0f)};
    std::array<Rgb, 2> colors{Rgb(1.0f), Rgb(1.0f)};
    bool operator==(const SegmentLight&) const = default;
};

/// Colours are at corner, corner + edge 0, corner + edge 1 and corner + both; bilinear between.
struct ParallelogramLight {
    glm::vec3 corner{0.0f};
    std::array<glm::vec3, 2> edges{glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)};
    std::array<Rgb, 4> colors{Rgb(1.0f), Rgb(1.0f), Rgb(1.0f), Rgb(1.0f)};
    bool operator==(const ParallelogramLight&) const = default;
};

struct Light {
    std::variant<PointLight, SegmentLight, ParallelogramLight> shape;
    Falloff falloff = Falloff::None;
    bool operator==(const Light&) const = default;
};

/// The radiance of rays that hit nothing: six cube faces in the order +x −x +y −y +z −z, or one
/// latitude-longitude image. Either `cube` is complete or `equirect` is set.
struct Environment {
    std::array<std::shared_ptr<const Texture>, 6> cube;
    std::shared_ptr<const Texture> equirect;
};

/// A setting of the scene file, with its position there.
struct SettingAssignment {
    std::string key, value;
    SourcePosition position;
};

/// The content of a scene file, editable. Copies are cheap: meshes and textures are shared.
struct SceneDescription {
    std::string path;   ///< as passed to loadScene(): a file or "builtin:NAME"
    std::string title;  ///< one sentence on what the scene shows
    std::vector<CameraDescription> cameras;
    std::vector<MeshInstance> meshes;
    std::vector<SphereInstance> spheres;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::shared_ptr<const Environment> environment;
    std::vector<SettingAssignment> settings;
    bool edited = false;  ///< differs from what loadScene() reads from `path`
};

/// Throws std::invalid_argument unless the arrays of the mesh have matching sizes and every vertex index is
/// valid.
void checkMesh(const MeshData& mesh);

/// Throws std::invalid_argument, with the name of the member, if a pointer is null, an index is out of range
/// or an image has no pixels. Descriptions from loadScene() are valid; functions that take a description
/// throw the same for an invalid one.
void checkDescription(const SceneDescription& scene);

/// Progress and cancellation of long operations on scenes, such as loadScene().
struct LoadControl {
    /// Called by the calling thread with the name of the step, e.g. "reading dragon.obj", and its progress 0
    /// … 1. It may throw, which ends the operation.
    std::function<void(const std::string& step, double fraction)> progress{};
    std::stop_token stop{};  ///< the operation throws Stopped soon after a request
};

/// The suffixes of files that loadScene() opens, in lower case and with the dot: ".toml" and those of mesh
/// files. The case of the suffix of a file does not matter.
std::vector<std::string> sceneFileSuffixes();

/// Loads a .toml scene, a bare mesh file (with its own cameras and lights, or else a framing
/// camera and a point light) or "builtin:NAME".
/// Throws InputError with file, line and column at the first error, and Stopped; appends notes and warnings
/// to `notes`.
SceneDescription loadScene(const std::string& path, Diagnostics& notes, const LoadControl& control = {});

/// The name, without "builtin:", and the title of a built-in scene.
struct BuiltinScene {
    std::string name, title;
};
/// In the order in which menus and lists show them.
std::vector<BuiltinScene> builtinScenes();

struct SceneBounds {
    glm::vec3 lower{-0.5f}, upper{0.5f};
    bool operator==(const SceneBounds&) const = default;
};
/// Bounds of all finite geometry at the start of the shutter; of an empty scene the unit box around the
/// origin. Throws Stopped.
SceneBounds boundsOf(const SceneDescription& scene, const LoadControl& control = {});

/// A camera that shows the whole box from the front (+z), slightly from above.
CameraDescription framingCamera(const SceneBounds& bounds);

/// A feature of the renderer that the scene needs or does not need, and the reason.
struct Requirement {
    std::string name;  ///< e.g. "parallelogram lights"
    bool needed = false;
    std::string reason;  ///< e.g. "1 parallelogram light"
};

/// The features that a scene needs; all others cost neither time nor memory.
struct SceneRequirements {
    std::size_t triangles = 0, spheres = 0;
    bool smoothNormals = false, vertexColors = false, textures = false, reflections = false,
         transparency = false;
    bool pointLights = false, segmentLights = false, parallelogramLights = false;
    bool environment = false, lens = false, motion = false;
    std::vector<Requirement> list;  ///< the same, as texts for users
};
SceneRequirements requirementsOf(const SceneDescription& scene);

/// Whether a lens or motion blurs pixels; the `blurred` of applyPreset().
inline bool blursPixels(const SceneRequirements& scene, const CameraDescription& camera) {
    return camera.lens || scene.motion;
}

/// Why the setting with this key has no effect in this scene; empty if it may have one.
std::string_view inactiveReason(const SceneRequirements& scene, std::string_view setting);

/// Probable mistakes in the scene: materials that do not conserve energy, degenerate triangles, unused
/// materials, sizes beyond the range of accurate hits … Those that `known`, the notes of loadScene(), has
/// already are left out. Throws Stopped.
Diagnostics lint(const SceneDescription& scene, const Diagnostics& known = {},
                 const LoadControl& control = {});

}  // namespace rayscope
