#include "scene/mesh_files/obj_reader.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>

#include "scene/mesh_files/mtl_reader.h"
#include "scene/mesh_files/obj_parser.h"
#include "scene/mesh_files/triangulate.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

void checkIndices(const std::string& path, const ParsedObj& obj) {
    const auto check = [&](std::int32_t index, std::size_t count, std::string_view what, std::size_t corner) {
        if (index >= 0 && static_cast<std::size_t>(index) >= count)
            failObjIndex(path, obj.firstLines[corner], what, static_cast<std::int64_t>(index) + 1, count);
    };
    const std::vector<Corner>& corners = obj.corners.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        check(corners[i].position, obj.positions.size(), "vertex", i);
        check(corners[i].texCoord, obj.texCoords.size(), "texture coordinate", i);
        check(corners[i].normal, obj.normals.size(), "normal", i);
    }
}

void report(const std::string& path, const ParsedObj& obj, Diagnostics& notes) {
    const auto note = [&](std::string message, int line) {
        notes.push_back({Severity::Note, std::move(message), {path, line, 0}});
    };
    if (obj.nonFiniteVertices > 0)
        note(fmt::format("{} vertices with NaN or infinite coordinates, the first one here; rays never hit "
                         "their triangles",
                         obj.nonFiniteVertices),
             obj.firstNonFiniteVertex);
    if (obj.degenerateFaces > 0)
        note(fmt::format("{} faces with fewer than three vertices, the first one here; ignored",
                         obj.degenerateFaces),
             obj.firstDegenerateFace);
    if (!obj.ignored.empty()) note(fmt::format("ignored statements: {}", fmt::join(obj.ignored, ", ")), 0);
}

/// Replaces the fans of polygons by triangulations, in place.
void triangulatePolygons(const ParsedObj& obj, MeshData& mesh) {
    std::vector<std::uint32_t> ring;
    std::vector<glm::vec3> points;
    std::vector<glm::uvec3> triangles;
    for (const ParsedObj::Polygon& polygon : obj.polygons) {
        glm::uvec3* const fan = &mesh.triangles[polygon.firstTriangle];
        ring = {fan[0].x, fan[0].y};
        for (std::uint32_t i = 0; i + 2 < polygon.corners; ++i) ring.push_back(fan[i].z);
        points.clear();
        for (const std::uint32_t vertex : ring) points.push_back(mesh.positions[vertex]);
        triangles.resize(polygon.corners - 2);
        triangulate(points, triangles);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            fan[i] = {ring[triangles[i].x], ring[triangles[i].y], ring[triangles[i].z]};
    }
}

/// Computes the normals of corners without one, in a file where others have one, as the mean of their faces
/// weighted by area.
void fillMissingNormals(const std::vector<Corner>& corners, MeshData& mesh) {
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 area = glm::cross(b - a, c - a);
        for (const std::uint32_t vertex : {t.x, t.y, t.z})
            if (corners[vertex].normal < 0) mesh.normals[vertex] += area;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i].normal >= 0) continue;
        const float length = glm::length(mesh.normals[i]);
        if (length > 0.0f) mesh.normals[i] /= length;
    }
}

std::shared_ptr<const MeshData> assemble(ParsedObj& obj) {
    auto mesh = std::make_shared<MeshData>();
    const std::vector<Corner>& corners = obj.corners.corners();
    std::size_t withNormal = 0, withTexCoord = 0;
    for (const Corner& corner : corners) {
        withNormal += corner.normal >= 0;
        withTexCoord += corner.texCoord >= 0;
    }
    mesh->positions.reserve(corners.size());
    if (withNormal > 0) mesh->normals.reserve(corners.size());
    if (withTexCoord > 0) mesh->texCoords.reserve(corners.size());
    for (const Corner& c : corners) {
        mesh->positions.push_back(obj.positions[static_cast<std::size_t>(c.position)]);
        if (withNormal > 0)
            mesh->normals.push_back(c.normal < 0 ? glm::vec3(0.0f)
                                                 : obj.normals[static_cast<std::size_t>(c.normal)]);
        if (withTexCoord > 0)
            mesh->texCoords.push_back(c.texCoord < 0 ? glm::vec2(0.0f)
                                                     : obj.texCoords[static_cast<std::size_t>(c.texCoord)]);
    }
    mesh->triangles = std::move(obj.triangles);
    mesh->triangles.shrink_to_fit();
    mesh->materialSlots = std::move(obj.slots);
    triangulatePolygons(obj, *mesh);
    if (withNormal > 0 && withNormal < corners.size()) fillMissingNormals(corners, *mesh);
    return mesh;
}

/// The materials of the files that mtllib statements name.
class MaterialLibrary {
  public:
    MaterialLibrary(const std::string& path, TextureCache& textures, Diagnostics& notes)
        : path_(path), textures_(textures), notes_(notes) {}

    /// Blanks are part of the file name if such a file exists; else they separate several names.
    void open(const ParsedObj::Named& library) {
        std::vector<std::string> files{library.name};
        if (!fileExists(resolvePath(path_, library.name))) {
            files.clear();
            std::istringstream words(library.name);
            for (std::string word; words >> word;) files.push_back(word);
        }
        for (const std::string& file : files) openFile(file, library.line);
    }

    std::vector<Material> materialsOf(const std::vector<ParsedObj::Named>& slots) {
        std::vector<Material> list;
        std::vector<const ParsedObj::Named*> undefined;
        for (const ParsedObj::Named& slot : slots) {
            const auto found = materials_.find(slot.name);
            list.push_back(found != materials_.end() ? found->second : Material{.name = slot.name});
            if (found == materials_.end() && !slot.name.empty()) undefined.push_back(&slot);
            if (list.back().name.empty()) list.back().name = "default";
        }
        if (!undefined.empty() && !isIncomplete_) {
            const std::string others =
                undefined.size() > 1 ? fmt::format(" and {} more", undefined.size() - 1) : "";
            warn(fmt::format("undefined material '{}'{}; a default material is used", undefined[0]->name,
                             others),
                 undefined[0]->line);
        }
        return list;
    }

  private:
    void warn(std::string message, int line) {
        notes_.push_back({Severity::Warning, std::move(message), {path_, line, 0}});
    }

    void openFile(const std::string& file, int line) {
        const std::string resolved = resolvePath(path_, file);
        if (!opened_.insert(resolved).second) return;
        if (!fileExists(resolved)) {
            isIncomplete_ = true;
            warn(fmt::format("material file not found: {}; default materials are used", resolved), line);
            return;
        }
        for (Material& material : readMtl(resolved, textures_, notes_))
            materials_.try_emplace(material.name, std::move(material));
    }

    const std::string& path_;
    TextureCache& textures_;
    Diagnostics& notes_;
    std::map<std::string, Material> materials_;
    std::set<std::string> opened_;
    bool isIncomplete_ = false;
};

}  // namespace

ImportedMesh readObj(const std::string& path, const ImportContext& context) {
    ParsedObj obj = parseObj(path);
    if (obj.triangles.empty()) throw InputError("the file has no faces (lines 'f …')", {path});
    checkIndices(path, obj);
    report(path, obj, context.notes);
    MaterialLibrary library(path, context.textures, context.notes);
    for (const ParsedObj::Named& name : obj.libraries) library.open(name);
    std::vector<Material> materials = library.materialsOf(obj.slotNames);
    return {assemble(obj), std::move(materials)};
}

}  // namespace rayscope::scene
