#include "trace/compile.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "base/check_argument.h"
#include "scene/check_description.h"

namespace rayscope::trace {

BuildSettings buildSettingsOf(const Settings& settings, std::stop_token stop) {
    return {.builder = settings.bvhBuilder,
            .bins = settings.bvhBins,
            .maxLevel = settings.bvhMaxLevel,
            .leafSize = settings.bvhLeafSize,
            .layout = settings.bvhLayout,
            .isa = settings.isa,
            .stop = std::move(stop)};
}

namespace {

/// Refits the BVH of the previous motion group if the same triangles have moved and its SAH cost has not
/// grown beyond `maxCostGrowth`; builds a new one otherwise.
std::shared_ptr<const Accel> makeAccel(const Geometry& geometry, const MotionGroup* previous,
                                       const BuildSettings& build, float maxCostGrowth) {
    const AccelInput& input = geometry.input;
    if (maxCostGrowth > 0.0f && previous && previous->accel &&
        previous->geometry->input.spheres.size() == input.spheres.size() &&
        std::ranges::equal(previous->geometry->input.triangles, input.triangles)) {
        Accel accel = previous->accel->refit(input, build.stop);
        if (accel.summary().costGrowth <= static_cast<double>(maxCostGrowth))
            return std::make_shared<const Accel>(std::move(accel));
    }
    return std::make_shared<const Accel>(Accel::build(input, build));
}

/// Shares geometry and BVHs with the previous world as far as they are the same.
void compileMotionGroups(World& world, const World* previous, bool keepBinaryTrees, std::stop_token stop) {
    const Settings& settings = world.settings;
    const bool sameShapes = previous && sameGeometry(*previous->description, *world.description) &&
                            previous->settings.motionBlur == settings.motionBlur;
    std::vector<std::shared_ptr<const Geometry>> geometries;
    if (sameShapes)
        for (const MotionGroup& group : previous->motionGroups) geometries.push_back(group.geometry);
    else
        geometries = makeGeometry(*world.description, settings.motionBlur);

    const bool sameBuild = previous && changed(previous->settings, settings) < Invalidates::Accel;
    const bool sameTrees = sameShapes && sameBuild;
    const bool sameGroups = sameBuild && previous->motionGroups.size() == geometries.size();
    BuildSettings build = buildSettingsOf(settings, std::move(stop));
    build.keepBinaryTree = keepBinaryTrees;
    const auto start = std::chrono::steady_clock::now();
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < geometries.size(); ++i) {
        MotionGroup group{geometries[i], nullptr, first};
        if (sameTrees && previous->motionGroups[i].accel)
            group.accel = previous->motionGroups[i].accel;
        else if (settings.bvh)
            group.accel = makeAccel(*group.geometry, sameGroups ? &previous->motionGroups[i] : nullptr, build,
                                    settings.bvhRefit);
        first += static_cast<std::uint32_t>(group.geometry->input.triangles.size() +
                                            group.geometry->input.spheres.size());
        world.moves |= group.geometry->motion != glm::vec3(0.0f);
        if (group.accel)
            world.buildReport.sahCostGrowth =
                std::max(world.buildReport.sahCostGrowth, group.accel->summary().costGrowth);
        world.motionGroups.push_back(std::move(group));
    }
    constexpr std::uint32_t kManyPrimitives = 1 << 16;
    world.hasSlowRays = !settings.bvh && world.primitiveCount() > kManyPrimitives;
    world.buildReport.seconds =
        sameTrees ? previous->buildReport.seconds
                  : std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool reflects(const Material& material, const Settings& settings) {
    if (!settings.recursion || material.ks == Rgb(0.0f)) return false;
    return settings.reflectWhen == ReflectWhen::Ks || (material.illum >= 3 && material.illum <= 9);
}

void compileMaterials(World& world, const World* previous, const std::stop_token& stop) {
    const Settings& settings = world.settings;
    const bool withLevels = settings.textureFilter == TextureFilter::Mipmap;
    std::map<const Texture*, std::shared_ptr<const shading::MipTexture>> made;
    const bool reusable =
        previous && (previous->settings.textureFilter == TextureFilter::Mipmap) == withLevels;
    if (reusable)
        for (const auto& texture : previous->textures) made[texture->source()] = texture;

    std::map<const Texture*, std::shared_ptr<const shading::MipTexture>> used;
    const auto textureOf = [&](const std::shared_ptr<const Texture>& source) -> const shading::MipTexture* {
        if (!source || !settings.textureMapping) return nullptr;
        auto& texture = made[source.get()];
        if (!texture) texture = std::make_shared<const shading::MipTexture>(source, withLevels, stop);
        used[source.get()] = texture;
        return texture.get();
    };
    for (const Material& material : world.description->materials)
        world.materials.push_back({glm::dvec3(material.kd), glm::dvec3(material.ks),
                                   static_cast<double>(material.shininess),
                                   settings.transparency ? static_cast<double>(material.opacity) : 1.0,
                                   reflects(material, settings), textureOf(material.kdTexture)});
    for (auto& [source, texture] : used) world.textures.push_back(texture);
}

void compileLights(World& world) {
    const Settings& settings = world.settings;
    for (const Light& light : world.description->lights)
        world.lights.push_back(
            {light, shading::sampleGrid(light, settings), shading::dimensionsOf(light),
             shading::dimensionsOf(light) == 0 ? settings.hardShadows : settings.softShadows});
    if (!settings.transparentShadows) return;
    for (const SurfaceMaterial& material : world.materials) world.attenuatesShadows |= material.opacity < 1.0;
}

/// Throws std::invalid_argument if the request breaks an invariant that tracing relies on. Meshes that
/// `previous` has, too, are not checked again.
void checkRequest(const CompileRequest& request, const World* previous) {
    base::checkArgument(request.scene != nullptr, "scene is null");
    base::checkArgument(request.width > 0 && request.height > 0, "image of {} x {} pixels", request.width,
                        request.height);
    checkSettings(request.settings);
    scene::checkReferences(*request.scene);
    std::set<std::pair<const MeshData*, std::size_t>> checked;  // with the number of materials
    if (previous)
        for (const MeshInstance& mesh : previous->description->meshes)
            checked.emplace(mesh.data.get(), mesh.materials.size());
    for (const MeshInstance& mesh : request.scene->meshes) {
        if (!checked.emplace(mesh.data.get(), mesh.materials.size()).second) continue;
        checkMesh(*mesh.data);
        scene::checkSlots(mesh);
    }
}

}  // namespace

std::shared_ptr<const World> compile(const CompileRequest& request, const World* previous,
                                     std::stop_token stop) {
    checkRequest(request, previous);
    auto world = std::make_shared<World>();
    world->description = request.scene;
    world->settings = request.settings;
    world->width = request.width;
    world->height = request.height;
    CameraDescription camera = request.camera;
    if (!request.settings.depthOfField) camera.lens.reset();
    world->camera = Camera(camera, request.width, request.height);
    if (request.settings.environment) world->environment = request.scene->environment;
    compileMaterials(*world, previous, stop);
    compileLights(*world);
    compileMotionGroups(*world, previous, request.keepBinaryTrees, std::move(stop));
    return world;
}

}  // namespace rayscope::trace
