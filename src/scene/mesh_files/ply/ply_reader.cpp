#include "scene/mesh_files/ply/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "scene/mesh_files/ply/ply_rows.h"
#include "scene/mesh_files/text/word_reader.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// As many triangles as the faces probably have, and not more than the file can hold. The lists of a binary
/// file that ends with its faces tell their number.
std::uint64_t expectedTriangles(const PlyPlan& plan, const base::BlockReader& input,
                                std::uint64_t bytesOfVertices) {
    const std::uint64_t faces = plan.countOf(plan.faces);
    if (faces == 0 || !input.size()) return 0;
    const PlyElement& element = plan.header.elements[plan.faces];
    const std::uint64_t bytes = input.remaining() - std::min(bytesOfVertices, input.remaining());
    if (plan.header.format == PlyFormat::Ascii) return std::min(faces, bytes / 8);
    const std::uint64_t fixed = element.smallestRow();
    if (faces > bytes / fixed) return bytes / fixed;
    const auto isIndices = [](PlyRole role) { return role == PlyRole::Indices; };
    const auto& roles = plan.roles[plan.faces];
    const auto indices = std::find_if(roles.begin(), roles.end(), isIndices) - roles.begin();
    const std::size_t size = sizeOf(element.properties[static_cast<std::size_t>(indices)].type);
    const std::uint64_t corners = (bytes - faces * fixed) / size;
    return std::clamp(corners, 3 * faces, 4 * faces) - 2 * faces;
}

void reserveMesh(const PlyPlan& plan, const base::BlockReader& input, PlyMesh& mesh) {
    const PlyElement& element = plan.header.elements[plan.vertices];
    const bool isAscii = plan.header.format == PlyFormat::Ascii;
    const std::uint64_t row = isAscii ? 2 * element.properties.size() : element.smallestRow();
    const std::uint64_t vertices = input.size() ? std::min(element.count, input.remaining() / row) : 0;
    mesh.reserve(vertices, expectedTriangles(plan, input, vertices * row));
}

class Textures {
  public:
    Textures(const std::string& path, const ImportContext& context) : path_(path), context_(context) {}

    Material materialOf(const std::string& name) {
        Material material{.name = name};
        const std::string file = findFile(name);
        try {
            material.kdTexture = context_.textures.open(file, TextureWrap::Repeat);
        } catch (const InputError& error) {
            warn(fmt::format("texture {}: {}; a plain material is used", file, error.diagnostic().message));
        }
        return material;
    }

  private:
    /// Names with folders of another machine are searched beside the file.
    std::string findFile(const std::string& name) const {
        std::string resolved = resolvePath(path_, name);
        if (fileExists(resolved)) return resolved;
        std::string beside = resolvePath(path_, std::filesystem::path(resolved).filename().string());
        return fileExists(beside) ? beside : resolved;
    }
    void warn(std::string message) {
        context_.notes.push_back({Severity::Warning, std::move(message), {path_}});
    }

    const std::string& path_;
    const ImportContext& context_;
};

std::vector<Material> materialsOf(const std::string& path, const PlyPlan& plan,
                                  const ImportContext& context) {
    const std::vector<std::string>& files = plan.header.textureFiles;
    const bool hasTexCoords = plan.hasTexCoords || plan.hasCornerTexCoords;
    if (!files.empty() && !hasTexCoords)
        context.notes.push_back(
            {Severity::Note, "the file names a texture, but has no texture coordinates; ignored", {path}});
    if (files.empty() || !hasTexCoords) return {Material{.name = "default"}};
    std::vector<Material> materials;
    Textures textures(path, context);
    for (const std::string& file : files) {
        materials.push_back(textures.materialOf(file));
        if (!plan.hasTextureNumbers) break;
    }
    return materials;
}

ImportedMesh readInLayout(const std::string& path, const ImportContext& context, PlyLayout layout) {
    base::BlockReader input(path);
    LoadStep step(context.control, fmt::format("reading {}", std::filesystem::path(path).filename().string()),
                  static_cast<std::size_t>(input.size().value_or(0)));
    Oddities oddities(path);
    const PlyPlan plan = planPly(path, readPlyHeader(path, input, oddities), context.withColors, oddities);
    PlyMesh mesh(plan, oddities, context.control);
    reserveMesh(plan, input, mesh);
    const PlyRows rows{path, input, plan, mesh, oddities, step};
    if (plan.header.format == PlyFormat::Ascii)
        readAsciiPly(rows, layout);
    else
        readBinaryPly(rows);
    if (layout == PlyLayout::Words)
        oddities.add(Severity::Warning,
                     "the rows are not one per line; they are read by their number of values");
    auto data = std::make_shared<const MeshData>(mesh.finish(path));
    oddities.report(context.notes);
    return {std::move(data), materialsOf(path, plan, context)};
}

}  // namespace

std::string endsEarly(const PlyElement& element, std::uint64_t row) {
    const std::string_view plural = element.name == "vertex" ? "vertices"
                                    : element.name == "face" ? "faces"
                                                             : "rows";
    const std::string of = plural == "rows" ? fmt::format(" of element '{}'", shown(element.name)) : "";
    return fmt::format("the file ends early: it has {} of {} {}{}", row, element.count, plural, of);
}

std::string badVertexIndex(const PlyPlan& plan, std::int64_t index) {
    if (index == kNoInteger) return "a vertex index is not an integer";
    if (plan.vertexCount() == 0)
        return fmt::format("vertex {} is out of range: the file has no vertex", index);
    return fmt::format("vertex {} is out of range: expected 0 to {}", index, plan.vertexCount() - 1);
}

ImportedMesh readPly(const std::string& path, const ImportContext& context) {
    try {
        return readInLayout(path, context, PlyLayout::Lines);
    } catch (const PlyLayoutError& wrongLayout) {
        try {
            return readInLayout(path, context, PlyLayout::Words);
        } catch (const InputError&) {
            throw wrongLayout.error;
        }
    }
}

}  // namespace rayscope::scene
