#include "scene/mesh_files/gltf/vertex_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace rayscope::scene {

namespace {

GltfIndex attribute(const GltfAttributes& attributes, const std::string& semantic) {
    const auto found = attributes.find(semantic);
    return found == attributes.end() ? GltfIndex{} : GltfIndex{found->second};
}

void store(std::vector<float>& values, std::size_t i, const glm::dvec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        values[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(v[axis]);
}

}  // namespace

glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

bool mirrors(const glm::dmat3& map) { return glm::dot(map[0], glm::cross(map[1], map[2])) < 0.0; }

// The cofactors: the inverse transpose times the determinant.
glm::dmat3 normalMapOf(const glm::dmat3& map) {
    const glm::dmat3 cofactors(glm::cross(map[1], map[2]), glm::cross(map[2], map[0]),
                               glm::cross(map[0], map[1]));
    return mirrors(map) ? -cofactors : cofactors;
}

GltfIndex GltfVertexReader::texCoordsOf(const GltfPrimitive& primitive) const {
    std::uint64_t set = 0;
    if (primitive.material)
        if (const auto& texture = document_.materials[*primitive.material].baseColorTexture)
            set = texture->texCoord;
    return attribute(primitive.attributes, fmt::format("TEXCOORD_{}", set));
}

std::vector<float> GltfVertexReader::readAttribute(GltfIndex accessor, std::uint32_t components,
                                                   std::size_t count) {
    if (!accessor) return {};
    std::vector<float> values = accessors_.floats(*accessor, components);
    if (values.size() == count * components) return values;
    oddities_.add(Severity::Warning,
                  "vertex attributes with another number of elements than positions; ignored");
    return {};
}

GltfVertices GltfVertexReader::read(const GltfPrimitive& primitive, std::span<const double> weights,
                                    bool withColors) {
    GltfVertices vertices;
    const std::uint32_t position = primitive.attributes.at("POSITION");
    if (primitive.isDraco && !accessors_.accessor(position).view)
        throw InputError(
            "the compression KHR_draco_mesh_compression is not supported; export the file "
            "without compression",
            {path_});
    vertices.positions = accessors_.floats(position, 3);
    vertices.count = vertices.positions.size() / 3;
    vertices.normals = readAttribute(attribute(primitive.attributes, "NORMAL"), 3, vertices.count);
    vertices.texCoords = readAttribute(texCoordsOf(primitive), 2, vertices.count);
    if (const GltfIndex color = attribute(primitive.attributes, "COLOR_0"); withColors && color) {
        vertices.colorComponents = accessors_.accessor(*color).components == 4 ? 4 : 3;
        vertices.colors = readAttribute(color, vertices.colorComponents, vertices.count);
    }
    for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i) {
        displace(vertices.positions, primitive.targets[i], "POSITION", weights[i]);
        displace(vertices.normals, primitive.targets[i], "NORMAL", weights[i]);
    }
    return vertices;
}

void GltfVertexReader::displace(std::vector<float>& values, const GltfAttributes& target,
                                const std::string& semantic, double weight) {
    if (weight == 0.0 || values.empty()) return;
    const std::vector<float> offsets = readAttribute(attribute(target, semantic), 3, values.size() / 3);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        values[i] = static_cast<float>(values[i] + weight * static_cast<double>(offsets[i]));
}

std::vector<glm::dmat4> GltfVertexReader::skinMatrices(const GltfPrimitive& primitive,
                                                       std::span<const glm::dmat4> joints,
                                                       std::size_t count) {
    std::vector<glm::dmat4> matrices;
    std::vector<double> sums(count, 0.0);
    for (int set = 0;; ++set) {
        const GltfIndex joint = attribute(primitive.attributes, fmt::format("JOINTS_{}", set));
        const GltfIndex weight = attribute(primitive.attributes, fmt::format("WEIGHTS_{}", set));
        if (!joint || !weight) break;
        const std::vector<float> numbers = readAttribute(joint, 4, count),
                                 weights = readAttribute(weight, 4, count);
        if (numbers.empty() || weights.empty()) break;
        matrices.resize(count, glm::dmat4(0.0));
        for (std::size_t i = 0; i < 4 * count; ++i) {
            if (weights[i] == 0.0f) continue;
            const auto number = static_cast<double>(numbers[i]);
            if (!(number >= 0.0 && number < static_cast<double>(joints.size())))
                throw InputError(
                    fmt::format("accessors[{}]: joint {} is out of range: the skin has {} joints", *joint,
                                number, joints.size()),
                    {path_});
            matrices[i / 4] += static_cast<double>(weights[i]) * joints[static_cast<std::size_t>(number)];
            sums[i / 4] += static_cast<double>(weights[i]);
        }
    }
    for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] /= sums[i];
    return matrices;
}

bool GltfVertexReader::applySkin(GltfVertices& vertices, const GltfPrimitive& primitive,
                                 std::span<const glm::dmat4> joints) {
    const std::vector<glm::dmat4> matrices = skinMatrices(primitive, joints, vertices.count);
    if (matrices.empty()) {
        oddities_.add(Severity::Warning,
                      "skinned primitives without joints and weights; their node places them");
        return false;
    }
    for (std::size_t i = 0; i < vertices.count; ++i) {
        store(vertices.positions, i,
              glm::dvec3(matrices[i] * glm::dvec4(vectorAt(vertices.positions, i), 1.0)));
        if (vertices.normals.empty()) continue;
        const glm::dmat3 normalMap = normalMapOf(glm::dmat3(matrices[i]));
        store(vertices.normals, i, unitOrZero(normalMap * vectorAt(vertices.normals, i)));
    }
    return true;
}

}  // namespace rayscope::scene
