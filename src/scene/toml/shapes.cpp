#include "scene/toml/shapes.h"

#include "scene/generate/generate.h"
#include "scene/toml/record.h"

namespace rayscope::scene {

namespace {

template <class Shape>
Field<Shape> cells(std::string_view key, int Shape::*first, int Shape::*second) {
    return {key, [=](const TomlValue& value, Shape& target) {
                const toml::array& array = readArray(value, 2, "integers");
                target.*first = readInteger({value.file, array[0], key}, 1, 10000);
                target.*second = readInteger({value.file, array[1], key}, 1, 10000);
            }};
}

const Record<QuadShape> kQuad{vector("size", &QuadShape::size, kPositive)};
const Record<BoxShape> kBox{vector("size", &BoxShape::size, kPositive), boolean("inward", &BoxShape::inward)};
const Record<UvSphereShape> kUvSphere{number("radius", &UvSphereShape::radius, kPositive),
                                      integer("segments", &UvSphereShape::segments, 3, 4096),
                                      integer("rings", &UvSphereShape::rings, 2, 4096)};
const Record<IcosphereShape> kIcosphere{number("radius", &IcosphereShape::radius, kPositive),
                                        integer("subdivisions", &IcosphereShape::subdivisions, 0, 9)};
const Record<TorusShape> kTorus{number("radius", &TorusShape::radius, kPositive),
                                number("tube_radius", &TorusShape::tubeRadius, kPositive),
                                integer("segments", &TorusShape::segments, 3, 4096),
                                integer("tube_segments", &TorusShape::tubeSegments, 3, 4096)};
const Record<TerrainShape> kTerrain{vector("size", &TerrainShape::size, kPositive),
                                    number("height", &TerrainShape::height, kNonNegative),
                                    cells("cells", &TerrainShape::cellsX, &TerrainShape::cellsZ),
                                    integer("seed", &TerrainShape::seed, 0, 1 << 30)};
const Record<TeapotShape> kTeapot{integer("resolution", &TeapotShape::resolution, 1, 512)};
const Record<MonkeyShape> kMonkey{integer("resolution", &MonkeyShape::resolution, 8, 256)};

struct ShapeReader {
    std::string_view name;
    MeshGenerator (*read)(const TomlValue&, std::string_view owner);
};

template <class Shape, const Record<Shape>& record>
MeshGenerator readAs(const TomlValue& value, std::string_view owner) {
    static constexpr std::array<std::string_view, 1> kShapeKey{"shape"};
    Shape shape;
    readRecord(value.file, readTable(value), owner, record, shape, kShapeKey);
    return [shape](const LoadControl& control) {
        if constexpr (requires { generate(shape, control); })
            return generate(shape, control);
        else
            return generate(shape);
    };
}

constexpr std::array<ShapeReader, 8> kShapes{{
    {"quad", readAs<QuadShape, kQuad>},
    {"box", readAs<BoxShape, kBox>},
    {"uv_sphere", readAs<UvSphereShape, kUvSphere>},
    {"icosphere", readAs<IcosphereShape, kIcosphere>},
    {"torus", readAs<TorusShape, kTorus>},
    {"terrain", readAs<TerrainShape, kTerrain>},
    {"teapot", readAs<TeapotShape, kTeapot>},
    {"monkey", readAs<MonkeyShape, kMonkey>},
}};

}  // namespace

MeshGenerator readShape(const TomlValue& value) {
    std::vector<std::string_view> names;
    names.reserve(kShapes.size());
    for (const ShapeReader& shape : kShapes) names.push_back(shape.name);
    const toml::node* name = readTable(value).get("shape");
    if (!name) value.fail(fmt::format("needs the key 'shape': {}", base::joinChoices(names)));
    const ShapeReader& shape = kShapes[readChoice({value.file, *name, "shape"}, names)];
    return shape.read(value, fmt::format("the shape '{}'", shape.name));
}

}  // namespace rayscope::scene
