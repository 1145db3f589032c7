#include "scene/mesh_files/gltf/gltf_reader.h"

#include <fmt/format.h>

#include "scene/load_step.h"
#include "scene/mesh_files/gltf/cameras_and_lights.h"
#include "scene/mesh_files/gltf/geometry.h"
#include "scene/mesh_files/gltf/materials.h"
#include "scene/mesh_files/gltf/node_accessors.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

std::string stepName(const std::string& path) {
    return "converting " + path.substr(path.find_last_of('/') + 1);
}

void readMeshes(const GltfDocument& document, const GltfPlacements& placements, GltfAccessorReader& accessors,
                LoadStep& step, GltfGeometry& geometry) {
    std::size_t done = 0;
    for (const GltfPlacement& placement : placements.meshes) {
        step.advanceTo(done++);
        const GltfMesh& mesh = document.meshes[placement.index];
        const GltfNode& node = document.nodes[placement.node];
        std::vector<glm::dmat4> joints;
        if (node.skin) joints = jointMatrices(document.skins[*node.skin], placements.toScene, accessors);
        const std::vector<glm::dmat4> instances = instanceMatrices(document, placement, accessors);
        for (const GltfPrimitive& primitive : mesh.primitives)
            geometry.add(primitive, node.weights.empty() ? mesh.weights : node.weights, joints, instances);
    }
}

}  // namespace

ImportedMesh readGltf(const std::string& path, const ImportContext& context) {
    Oddities oddities(path);
    const std::string file = readSource(path, context.control);
    const GltfContainer container = splitGltfFile(file, path, oddities);
    const JsonDocument json(container.json, !container.isBinary, path);
    const GltfDocument document = readGltfDocument(json.root(), oddities);
    const GltfPlacements placements = placementsOf(document, path, oddities);

    GltfResources resources(path, container, document, context.control, oddities);
    GltfAccessorReader accessors(path, document, resources);
    GltfGeometry geometry(path, document, accessors, placements.meshes, context.withColors, oddities);
    LoadStep step(context.control, stepName(path), placements.meshes.size());
    readMeshes(document, placements, accessors, step, geometry);
    if (geometry.isEmpty())
        throw InputError("the scene of the file has no triangles" + oddities.appendix(), {path});

    ImportedMesh result;
    GltfMaterialConverter converter(path, document, resources, context.textures, context.notes, oddities);
    LoadStep materials(context.control, stepName(path) + ": materials", geometry.slots().size());
    for (const GltfIndex& slot : geometry.slots()) {
        materials.advanceTo(result.materials.size());
        result.materials.push_back(converter.convert(slot));
    }
    geometry.multiplyColors(result.materials);
    result.data = std::make_shared<MeshData>(geometry.take());
    SceneDescription scene;
    scene.meshes.push_back({.data = result.data});
    const SceneBounds bounds = boundsOf(scene, context.control);
    result.cameras = gltfCameras(document, placements.cameras, bounds, oddities);
    result.lights = gltfLights(document, placements.lights, bounds, oddities);
    oddities.report(context.notes);
    return result;
}

}  // namespace rayscope::scene
