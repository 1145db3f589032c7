#include "scene/mesh_files/obj/obj_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/srgb.h"
#include "scene/load_step.h"
#include "scene/mesh_files/geometry/missing_normals.h"
#include "scene/mesh_files/geometry/triangulate.h"
#include "scene/mesh_files/obj/obj_materials.h"
#include "scene/mesh_files/obj/obj_parser.h"
#include "scene/mesh_files/text/text_file.h"

namespace rayscope::scene {

namespace {

/// Replaces the fans of polygons by triangulations, in place.
void triangulatePolygons(const ParsedObj& obj, MeshData& mesh, Oddities& oddities, LoadStep step) {
    std::vector<std::uint32_t> ring;
    std::vector<glm::vec3> points;
    std::vector<glm::uvec3> triangles;
    std::size_t done = 0;
    for (const ParsedObj::Polygon& polygon : obj.polygons) {
        glm::uvec3* const fan = &mesh.triangles[polygon.firstTriangle];
        ring = {fan[0].x, fan[0].y};
        for (std::uint32_t i = 0; i + 2 < polygon.corners; ++i) ring.push_back(fan[i].z);
        points.clear();
        for (const std::uint32_t vertex : ring) points.push_back(mesh.positions[vertex]);
        triangles.resize(polygon.corners - 2);
        const bool isSimple =
            triangulate(points, triangles, [&](std::size_t cut) { step.advanceTo(done + cut); });
        if (!isSimple) oddities.add(Severity::Warning, kCrossingOutline, polygon.line);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            fan[i] = {ring[triangles[i].x], ring[triangles[i].y], ring[triangles[i].z]};
        done += triangles.size();
        step.advanceTo(done);
    }
}

/// The colours of the corners, linear. They are written encoded with the sRGB curve, from 0 to 1; some
/// programs write 0 to 255.
void addColors(const ParsedObj& obj, MeshData& mesh, Oddities& oddities) {
    float largest = 0.0f;
    for (const Rgb& color : obj.colors)
        for (int i = 0; i < 3; ++i)
            if (std::isfinite(color[i])) largest = std::max(largest, color[i]);
    // Rounding may put colours from 0 to 1 slightly above 1.
    const bool areBytes = largest > 2.0f;
    const float scale = areBytes ? 1.0f / 255.0f : 1.0f;
    if (areBytes) oddities.add(Severity::Warning, "vertex colours above 2; all are read as 0 to 255");
    std::size_t without = 0, outside = 0;
    mesh.colors.reserve(obj.corners.size());
    for (const Corner& corner : obj.corners) {
        const Rgb written = scale * obj.colors[static_cast<std::size_t>(corner.position)];
        const bool isGiven = !std::isnan(written.r) && !std::isnan(written.g) && !std::isnan(written.b);
        const Rgb color = isGiven ? glm::clamp(written, 0.0f, 1.0f) : Rgb(1.0f);
        without += !isGiven;
        outside += isGiven && color != written;
        mesh.colors.emplace_back(image::srgbToLinear(color.r), image::srgbToLinear(color.g),
                                 image::srgbToLinear(color.b));
    }
    oddities.add(Severity::Note, "vertices without a colour in a file with colours; white is used", 0,
                 without);
    oddities.add(Severity::Warning, "colours of vertices out of range; clamped", 0, outside);
}

/// Vertices from the distinct corners.
void addVertices(const ParsedObj& obj, MeshData& mesh) {
    std::size_t withNormal = 0, withTexCoord = 0;
    for (const Corner& corner : obj.corners) {
        withNormal += corner.normal >= 0;
        withTexCoord += corner.texCoord >= 0;
    }
    mesh.positions.reserve(obj.corners.size());
    if (withNormal > 0) mesh.normals.reserve(obj.corners.size());
    if (withTexCoord > 0) mesh.texCoords.reserve(obj.corners.size());
    for (const Corner& c : obj.corners) {
        mesh.positions.push_back(obj.positions[static_cast<std::size_t>(c.position)]);
        if (withNormal > 0)
            mesh.normals.push_back(c.normal < 0 ? glm::vec3(0.0f)
                                                : obj.normals[static_cast<std::size_t>(c.normal)]);
        if (withTexCoord > 0)
            mesh.texCoords.push_back(c.texCoord < 0 ? glm::vec2(0.0f)
                                                    : obj.texCoords[static_cast<std::size_t>(c.texCoord)]);
    }
}

void addMissingNormals(const ParsedObj& obj, MeshData& mesh, Oddities& oddities) {
    if (mesh.normals.empty()) return;
    std::vector<bool> isMissing(obj.corners.size());
    for (std::size_t i = 0; i < obj.corners.size(); ++i) isMissing[i] = obj.corners[i].normal < 0;
    const auto count = static_cast<std::size_t>(std::count(isMissing.begin(), isMissing.end(), true));
    if (count == 0) return;
    oddities.add(Severity::Note, "corners without a normal in a file with normals; computed from the faces",
                 0, count);
    computeMissingNormals(isMissing, mesh);
}

/// Corners without texture coordinates, in a mesh where others have some, whose material has a texture.
void noteUntexturedCorners(const ParsedObj& obj, const ImportedMesh& mesh, Oddities& oddities) {
    if (mesh.data->texCoords.empty()) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.data->triangles.size(); ++i) {
        const std::size_t slot = mesh.data->materialSlots.empty() ? 0 : mesh.data->materialSlots[i];
        if (!mesh.materials[slot].kdTexture) continue;
        const glm::uvec3 t = mesh.data->triangles[i];
        count +=
            obj.corners[t.x].texCoord < 0 || obj.corners[t.y].texCoord < 0 || obj.corners[t.z].texCoord < 0;
    }
    oddities.add(Severity::Warning,
                 "triangles with a texture but without texture coordinates; the texture is sampled at (0, 0)",
                 0, count);
}

}  // namespace

ImportedMesh readObj(const std::string& path, const ImportContext& context) {
    Oddities oddities(path);
    ParsedObj obj =
        parseObj(path, readTextFile(path, "OBJ", oddities, context.control), oddities, context.control);
    auto data = std::make_shared<MeshData>();
    addVertices(obj, *data);
    if (!obj.colors.empty() && context.withColors) addColors(obj, *data, oddities);
    if (!obj.colors.empty() && !context.withColors) oddities.add(Severity::Note, kColorsNotShown);
    data->triangles = std::move(obj.triangles);
    data->triangles.shrink_to_fit();
    data->materialSlots = std::move(obj.slots);
    std::size_t corners = 0;
    for (const ParsedObj::Polygon& polygon : obj.polygons) corners += polygon.corners - 2;
    triangulatePolygons(
        obj, *data, oddities,
        {context.control, "triangulating " + path.substr(path.find_last_of('/') + 1), corners});
    addMissingNormals(obj, *data, oddities);
    ImportedMesh mesh{data, readObjMaterials(path, obj, context)};
    noteUntexturedCorners(obj, mesh, oddities);
    oddities.report(context.notes);
    return mesh;
}

}  // namespace rayscope::scene
