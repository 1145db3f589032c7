#include "scene/toml/entries.h"

#include "scene/check_camera.h"
#include "scene/environment_shape.h"
#include "scene/toml/shapes.h"
#include "scene/toml/textures.h"

namespace rayscope::scene {

namespace {

LocatedText readTextAt(const TomlValue& value) {
    LocatedText text{readText(value), value.position()};
    if (text.text.empty()) value.fail("expected a name, got an empty string");
    return text;
}

template <class T>
Field<T> locatedText(std::string_view key, std::optional<LocatedText> T::*member) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readTextAt(value); }};
}

// ---------------------------------------------------------------- cameras

const Record<Lens>& lensRecord() {
    static const Record<Lens> record{number("f_number", &Lens::fNumber, kPositive),
                                     number("focal_length", &Lens::focalLength, kPositive),
                                     number("focus_distance", &Lens::focusDistance, kPositive)};
    return record;
}

const Record<CameraDescription>& cameraRecord() {
    using C = CameraDescription;
    static const Record<C> record{
        text("name", &C::name),
        vector("look_from", &C::lookFrom).required(),
        vector("look_at", &C::lookAt),
        vector("up", &C::up),
        number("fov", &C::fov, {.lowest = 0.0, .highest = 180.0, .openLow = true, .openHigh = true}),
        table("lens", &C::lens, lensRecord()),
    };
    return record;
}

// ---------------------------------------------------------------- lights

constexpr std::array<std::string_view, 3> kLightTypes{"point", "segment", "parallelogram"};
constexpr std::array<std::string_view, 2> kFalloffs{"none", "inverse_square"};
constexpr std::array<std::string_view, 2> kLightKeys{"type", "falloff"};

const Record<PointLight>& pointLightRecord() {
    static const Record<PointLight> record{vector("position", &PointLight::position).required(),
                                           color("color", &PointLight::color, kNonNegative)};
    return record;
}

const Record<SegmentLight>& segmentLightRecord() {
    static const Record<SegmentLight> record{vectors("endpoints", &SegmentLight::endpoints).required(),
                                             colors("colors", &SegmentLight::colors, kNonNegative)};
    return record;
}

const Record<ParallelogramLight>& parallelogramLightRecord() {
    using L = ParallelogramLight;
    static const Record<L> record{vector("corner", &L::corner).required(),
                                  vectors("edges", &L::edges).required(),
                                  colors("colors", &L::colors, kNonNegative)};
    return record;
}

// ---------------------------------------------------------------- materials and textures

constexpr std::array<std::string_view, 2> kWraps{"repeat", "clamp"};

TextureEntry readTexture(const TomlValue& value) {
    TextureEntry entry;
    if (value.node.is_string()) {
        entry.file = readTextAt(value);
        return entry;
    }
    if (!value.node.is_table()) value.failType("a file name or a table with file or generate");
    const toml::table& body = readTable(value);
    const Record<TextureEntry> common{choice("wrap", &TextureEntry::wrap, kWraps)};
    if (body.contains("generate")) {
        const auto keys = generatedTextureKeys();
        readRecord(value.file, body, "a generated texture", common, entry, keys);
        entry.image = readGeneratedTexture(value);
        return entry;
    }
    Record<TextureEntry> record = common;
    record.push_back(
        {"file", [](const TomlValue& v, TextureEntry& target) { target.file = readTextAt(v); }, true});
    readRecord(value.file, body, "a texture", record, entry);
    return entry;
}

template <class T>
Field<MaterialEntry> ofMaterial(Field<T> field) {
    return {field.key, [=](const TomlValue& value, MaterialEntry& t) { field.read(value, t.material); }};
}

const Record<MaterialEntry>& materialRecord() {
    using M = Material;
    static const Record<MaterialEntry> record{
        ofMaterial(color("kd", &M::kd)),
        ofMaterial(color("ks", &M::ks)),
        ofMaterial(number("shininess", &M::shininess, kNonNegative)),
        ofMaterial(number("opacity", &M::opacity, kFraction)),
        ofMaterial(integer("illum", &M::illum, 0, 10)),
        {"kd_texture", [](const TomlValue& value, MaterialEntry& t) { t.texture = readTexture(value); }},
    };
    return record;
}

// ---------------------------------------------------------------- meshes and spheres

/// Row-major in the file; GLM stores columns.
glm::mat4 readMatrix(const TomlValue& value) {
    const toml::array& array = readArray(value, 16, "numbers, row by row");
    glm::mat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = readNumber(
                {value.file, array[static_cast<std::size_t>(4 * row + column)], value.key}, kAnyNumber);
    for (int column = 0; column < 4; ++column)
        if (matrix[column][3] != (column == 3 ? 1.0f : 0.0f)) value.fail("the last row must be 0, 0, 0, 1");
    if (glm::determinant(glm::dmat3(glm::mat3(matrix))) == 0.0)
        value.fail("singular matrix: its determinant is 0");
    return matrix;
}

Transform readTransform(const TomlValue& value) {
    static const Record<Transform> record{
        number("scale", &Transform::scale, kPositive),
        vector("rotate", &Transform::rotate),
        vector("translate", &Transform::translate),
        {"matrix", [](const TomlValue& v, Transform& target) { target.matrix = readMatrix(v); }},
    };
    Transform transform;
    const toml::table& body = readTable(value);
    readRecord(value.file, body, value.key, record, transform);
    if (transform.matrix && body.size() > 1) value.fail("matrix excludes the other keys; remove it or them");
    return transform;
}

const Record<MeshEntry>& meshRecord() {
    static const Record<MeshEntry> record{
        {"name", [](const TomlValue& value, MeshEntry& t) { t.instance.name = readText(value); }},
        locatedText("file", &MeshEntry::file),
        {"generate", [](const TomlValue& value, MeshEntry& t) { t.generate = readShape(value); }},
        {"transform",
         [](const TomlValue& value, MeshEntry& t) { t.instance.transform = readTransform(value); }},
        locatedText("material", &MeshEntry::material),
        {"motion", [](const TomlValue& value, MeshEntry& t) { t.instance.motion = readVector<3>(value); }},
        {"vertex_colors",
         [](const TomlValue& value, MeshEntry& t) {
             t.instance.vertexColors = readBoolean(value);
             t.vertexColors = value.position();
         }},
        text("if_missing", &MeshEntry::ifMissing),
    };
    return record;
}

const Record<SphereEntry>& sphereRecord() {
    static const Record<SphereEntry> record{
        {"name", [](const TomlValue& value, SphereEntry& t) { t.instance.name = readText(value); }},
        {"center",
         [](const TomlValue& value, SphereEntry& t) { t.instance.sphere.center = readVector<3>(value); },
         true},
        {"radius",
         [](const TomlValue& value, SphereEntry& t) {
             t.instance.sphere.radius = readNumber(value, kPositive);
         },
         true},
        locatedText("material", &SphereEntry::material),
        {"motion", [](const TomlValue& value, SphereEntry& t) { t.instance.motion = readVector<3>(value); }},
    };
    return record;
}

// ---------------------------------------------------------------- environment

void readCube(const TomlValue& value, EnvironmentEntry& entry) {
    Record<EnvironmentEntry> record;
    for (std::size_t face = 0; face < kCubeFaces.size(); ++face)
        record.push_back({kCubeFaces[face],
                          [face](const TomlValue& v, EnvironmentEntry& t) { t.cube[face] = readTextAt(v); },
                          true});
    readRecord(value.file, readTable(value), "a cube environment", record, entry);
}

const Record<EnvironmentEntry>& environmentRecord() {
    static constexpr std::array<std::string_view, 1> kGenerators{"sky"};
    static const Record<EnvironmentEntry> record{
        {"cube", readCube},
        {"equirect", [](const TomlValue& value, EnvironmentEntry& t) { t.equirect = readTextAt(value); }},
        {"generate",
         [](const TomlValue& value, EnvironmentEntry& t) { t.sky = readChoice(value, kGenerators) == 0; }},
    };
    return record;
}

}  // namespace

CameraDescription readCamera(const TomlValue& value) {
    CameraDescription camera;
    camera.name.clear();
    readRecord(value.file, readTable(value), "a camera", cameraRecord(), camera);
    if (const std::string_view problem = scene::problemOf(camera); !problem.empty()) value.fail(problem);
    return camera;
}

Light readLight(const TomlValue& value) {
    const toml::table& body = readTable(value);
    const toml::node* type = body.get("type");
    if (!type) value.fail(fmt::format("needs the key 'type': {}", base::joinChoices(kLightTypes)));
    const std::size_t kind = readChoice({value.file, *type, "type"}, kLightTypes);

    Light light;
    const auto readAs = [&](auto shape, const auto& record, std::string_view owner) {
        readRecord(value.file, body, owner, record, shape, kLightKeys);
        light.shape = shape;
    };
    if (kind == 0) readAs(PointLight{}, pointLightRecord(), "a point light");
    if (kind == 1) readAs(SegmentLight{}, segmentLightRecord(), "a segment light");
    if (kind == 2) readAs(ParallelogramLight{}, parallelogramLightRecord(), "a parallelogram light");
    if (const toml::node* falloff = body.get("falloff"))
        light.falloff = static_cast<Falloff>(readChoice({value.file, *falloff, "falloff"}, kFalloffs));
    return light;
}

MaterialEntry readMaterial(const TomlValue& value) {
    MaterialEntry entry;
    entry.material.name = value.key;
    readRecord(value.file, readTable(value), "a material", materialRecord(), entry);
    return entry;
}

MeshEntry readMesh(const TomlValue& value) {
    MeshEntry entry;
    readRecord(value.file, readTable(value), "a mesh", meshRecord(), entry);
    if (entry.file.has_value() == (entry.generate != nullptr))
        value.fail("needs either file = \"NAME\" or generate = { shape = … }");
    return entry;
}

SphereEntry readSphere(const TomlValue& value) {
    SphereEntry entry;
    readRecord(value.file, readTable(value), "a sphere", sphereRecord(), entry);
    return entry;
}

EnvironmentEntry readEnvironment(const TomlValue& value) {
    EnvironmentEntry entry;
    const toml::table& body = readTable(value);
    readRecord(value.file, body, "an environment", environmentRecord(), entry);
    if (body.size() != 1) value.fail("needs one of cube, equirect and generate");
    return entry;
}

}  // namespace rayscope::scene
