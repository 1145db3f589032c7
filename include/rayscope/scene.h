#pragma once
#include <rayscope/diagnostics.h>
#include <rayscope/image.h>
#include <rayscope/ray.h>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rayscope {

/// A lens makes depth of field; without one a camera is a pinhole. Lengths in scene units.
struct Lens {
    float fNumber = 2.8f;  ///< aperture diameter = focal length / f-number
    float focalLength = 0.05f;
    float focusDistance = 3.0f;  ///< distance of the plane that is imaged sharply
    bool operator==(const Lens&) const = default;
};

struct CameraDescription {
    std::string name = "main";
    glm::vec3 lookFrom{0.0f, 0.0f, 3.0f};
    glm::vec3 lookAt{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float fov = 50.0f;  ///< vertical angle of view, degrees
    std::optional<Lens> lens;
    bool operator==(const CameraDescription&) const = default;
};

enum class TextureWrap { Repeat, Clamp };

struct Texture {
    std::string file;
    RgbImage image;  ///< linear
    TextureWrap wrap = TextureWrap::Repeat;
};

/// Phong's reflection model. Kd and Ks are the fractions of light that are reflected diffusely and
/// specularly.
struct Material {
    std::string name;
    Rgb kd{0.8f};
    Rgb ks{0.0f};
    float shininess = 1.0f;
    float opacity = 1.0f;  ///< 1 is opaque, 0 invisible
    int illum = -1;        ///< MTL's illumination model; -1: not given
    std::shared_ptr<const Texture> kdTexture{};
};

/// Triangles with shared vertices, immutable once read. `normals` and `texCoords` are empty or as long as
/// `positions`.
struct MeshData {
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{};
    std::vector<glm::vec2> texCoords{};  ///< (0, 0) is the lower left corner of the image
    std::vector<glm::uvec3> triangles{};
    std::vector<std::uint16_t> materialSlots{};  ///< per triangle, or empty if all use slot 0
};

/// scale, then rotation about x, y, z in this order (degrees), then translation; or any affine map.
struct Transform {
    float scale = 1.0f;
    glm::vec3 rotate{0.0f};
    glm::vec3 translate{0.0f};
    std::optional<glm::mat4> matrix;  ///< replaces the other three
    bool operator==(const Transform&) const = default;
    bool isIdentity() const { return *this == Transform{}; }
};
glm::dmat4 matrixOf(const Transform& transform);

struct MeshInstance {
    std::string name{};
    std::shared_ptr<const MeshData> data{};
    Transform transform{};
    std::vector<std::uint32_t> materials{};  ///< slot of the mesh → index into SceneDescription::materials
    glm::vec3 motion{0.0f};                  ///< displacement during the shutter, scene units
};

struct SphereInstance {
    std::string name;
    Sphere sphere;
    std::uint32_t material = 0;
    glm::vec3 motion{0.0f};
    bool operator==(const SphereInstance& o) const {
        return name == o.name && sphere.center == o.sphere.center && sphere.radius == o.sphere.radius &&
               material == o.material && motion == o.motion;
    }
};

enum class Falloff { None, InverseSquare };

struct PointLight {
    glm::vec3 position{0.0f};
    Rgb color{1.0f};
    bool operator==(const PointLight&) const = default;
};

/// A line whose colour goes linearly from one end to the other.
struct SegmentLight {
    std::array<glm::vec3, 2> endpoints{glm::vec3(0.0f), glm::vec3(1.0f)};
    std::array<Rgb, 2> colors{Rgb(1.0f), Rgb(1.0f)};
    bool operator==(const SegmentLight&) const = default;
};

/// Colours stand at corner, corner + edge 0, corner + edge 1, corner + both; bilinear between.
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

/// What rays see that leave the scene: six faces in the order +x −x +y −y +z −z, or one latitude-longitude
/// image.
struct Environment {
    std::array<std::shared_ptr<const Texture>, 6> cube;
    std::shared_ptr<const Texture> equirect;
};

/// A setting that the scene file asks for, with the place where it does.
struct SettingAssignment {
    std::string key, value;
    SourcePosition position;
};

/// What a scene file says; editable. Copies are cheap: meshes and textures are shared.
struct SceneDescription {
    std::string path;   ///< as given: a file or "builtin:NAME"
    std::string title;  ///< one sentence on what the scene shows
    std::vector<CameraDescription> cameras;
    std::vector<MeshInstance> meshes;
    std::vector<SphereInstance> spheres;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::shared_ptr<const Environment> environment;
    std::vector<SettingAssignment> settings;
};

/// Opens a .toml scene, a bare .obj (with a framing camera and a light) or "builtin:NAME".
/// Throws InputError with file, line and column at the first thing that is wrong; what is only odd goes to
/// `notes`.
SceneDescription loadScene(const std::string& path, Diagnostics& notes);

/// The names that "builtin:" knows, in the order in which they are best shown, and a sentence on each.
struct BuiltinScene {
    std::string name, title;
};
std::vector<BuiltinScene> builtinScenes();

/// Bounds of all geometry at the start of the shutter; an empty scene gives the unit box around the origin.
struct SceneBounds {
    glm::vec3 lower{-0.5f}, upper{0.5f};
};
SceneBounds boundsOf(const SceneDescription& scene);

/// A camera that shows the whole scene from the front, slightly from above.
CameraDescription framingCamera(const SceneBounds& bounds);

/// One facility that tracing this scene needs or does without, and because of what.
struct Requirement {
    std::string name;  ///< e.g. "area lights"
    bool needed = false;
    std::string because;  ///< e.g. "1 parallelogram light"
};

/// What a scene needs; everything else is neither built, stored, sampled nor drawn.
struct SceneRequirements {
    std::size_t triangles = 0, spheres = 0;
    bool smoothNormals = false, textures = false, reflections = false, transparency = false;
    bool pointLights = false, segmentLights = false, parallelogramLights = false;
    bool environment = false, lens = false, motion = false;
    std::vector<Requirement> list;  ///< the same facts in words
};
SceneRequirements requirementsOf(const SceneDescription& scene);

/// Whether a lens or motion blurs pixels: what applyPreset() asks.
inline bool blursPixels(const SceneRequirements& scene, const CameraDescription& camera) {
    return camera.lens || scene.motion;
}

/// Why the setting with this key changes nothing in this scene, or an empty text if it may change something.
std::string_view inactiveReason(const SceneRequirements& scene, std::string_view setting);

/// What is odd about the scene, for the person who made it: energy above one, degenerate triangles, unused
/// things …
Diagnostics lint(const SceneDescription& scene);

}  // namespace rayscope
