#include "viewer/view/raster_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>

#include "math/vectors.h"

namespace rayscope::viewer {

namespace {

constexpr int kMaxLights = 8;  // as many as shaders/surface.frag has room for

/// A light as a point.
struct LightSpot {
    glm::vec3 position;
    Rgb color;
};
LightSpot spotOf(const PointLight& light) { return {light.position, light.color}; }
LightSpot spotOf(const SegmentLight& light) {
    return {(light.endpoints[0] + light.endpoints[1]) * 0.5f, (light.colors[0] + light.colors[1]) * 0.5f};
}
LightSpot spotOf(const ParallelogramLight& light) {
    const auto& c = light.colors;
    return {light.corner + (light.edges[0] + light.edges[1]) * 0.5f, (c[0] + c[1] + c[2] + c[3]) * 0.25f};
}

glm::dmat4 sphereModel(const Sphere& sphere) {
    glm::dmat4 model(static_cast<double>(sphere.radius));
    model[3] = glm::dvec4(glm::dvec3(sphere.center), 1.0);
    return model;
}

glm::dvec3 meanOf(const std::vector<glm::vec3>& positions) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3& position : positions) sum += glm::dvec3(position);
    return sum / static_cast<double>(std::max<std::size_t>(positions.size(), 1));
}

/// The linear map of normals, up to a positive factor.
glm::mat3 normalMatrix(const glm::dmat4& model) {
    const glm::dmat3 m = glm::transpose(glm::inverse(glm::dmat3(model)));
    double largest = 0.0;
    for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(m[i / 3][i % 3]));
    return glm::mat3(largest > 0.0 ? m * (1.0 / largest) : m);
}

}  // namespace

RasterView::RasterView(std::size_t maxTrianglesMoving)
    : sphere_(std::make_shared<const MeshData>(unitSphereMesh())), maxTrianglesMoving_(maxTrianglesMoving) {
    glGenVertexArrays(1, &emptyVertexArray_);
}

RasterView::~RasterView() { glDeleteVertexArrays(1, &emptyVertexArray_); }

void RasterView::setScene(std::shared_ptr<const SceneDescription> scene, const SceneBounds& bounds) {
    scene_ = std::move(scene);
    bounds_ = bounds;
    scale_ = 1.0 / drawingUnit(math::distance(bounds_.lower, bounds_.upper));

    std::map<std::shared_ptr<const MeshData>, std::unique_ptr<DrawableMesh>> meshes;
    for (const MeshInstance& instance : scene_->meshes) {
        std::unique_ptr<DrawableMesh>& loaded = meshes[instance.data];
        const auto known = meshes_.find(instance.data);
        if (loaded) continue;
        loaded =
            known != meshes_.end() ? std::move(known->second) : std::make_unique<DrawableMesh>(instance.data);
    }
    meshes_ = std::move(meshes);

    std::map<std::shared_ptr<const Texture>, GlTexture> textures;
    for (const Material& material : scene_->materials) {
        if (!material.kdTexture || material.kdTexture->image.empty()) continue;
        GlTexture& loaded = textures[material.kdTexture];
        if (!loaded.empty()) continue;
        const auto known = textures_.find(material.kdTexture);
        loaded =
            known != textures_.end() ? std::move(known->second) : GlTexture::forMaterial(*material.kdTexture);
    }
    textures_ = std::move(textures);
    collectItems();
    distributeTriangles();
}

void RasterView::collectItems() {
    opaque_.clear();
    transparent_.clear();
    const auto isTransparent = [&](std::size_t material) {
        return material < scene_->materials.size() && scene_->materials[material].opacity < 1.0f;
    };
    for (const MeshInstance& instance : scene_->meshes) {
        DrawableMesh& mesh = *meshes_.at(instance.data);
        const glm::dmat4 model = matrixOf(instance.transform);
        std::optional<glm::dvec3> center;  // of large meshes takes long
        for (const MeshBuffer::Range& range : mesh.whole().ranges()) {
            const std::size_t slot = std::min<std::size_t>(range.slot, instance.materials.size() - 1);
            const std::size_t material = instance.materials.empty() ? 0 : instance.materials[slot];
            if (!isTransparent(material)) {
                opaque_.push_back({&mesh, range.slot, model, material, {}, instance.vertexColors});
                continue;
            }
            if (!center) center = glm::dvec3(model * glm::dvec4(meanOf(instance.data->positions), 1.0));
            transparent_.push_back({&mesh, range.slot, model, material, *center, instance.vertexColors});
        }
    }
    for (const SphereInstance& sphere : scene_->spheres)
        (isTransparent(sphere.material) ? transparent_ : opaque_)
            .push_back(
                {&sphere_, 0, sphereModel(sphere.sphere), sphere.material, glm::dvec3(sphere.sphere.center)});
}

/// While something moves, the triangle limit is distributed over the meshes in proportion to their sizes.
void RasterView::distributeTriangles() {
    constexpr double kFewest = 48.0;
    double all = static_cast<double>(sphere_.triangles() * scene_->spheres.size());
    for (const MeshInstance& instance : scene_->meshes)
        all += static_cast<double>(instance.data->triangles.size());
    const double fraction = static_cast<double>(maxTrianglesMoving_) / std::max(all, 1.0);
    const auto limit = [&](DrawableMesh& mesh) {
        const double most =
            std::max(kFewest, static_cast<double>(mesh.triangles()) * std::min(fraction, 1.0));
        mesh.prepareProxy(static_cast<std::size_t>(most));
    };
    for (const auto& [data, mesh] : meshes_) limit(*mesh);
    if (!scene_->spheres.empty()) limit(sphere_);
}

/// Drawn once per size and kept.
void RasterView::drawBackground(const RenderTarget& target) {
    glDisable(GL_DEPTH_TEST);
    if (backdrop_.resize(target.width(), target.height())) {
        backdrop_.bind();
        background_.use();
        glBindVertexArray(emptyVertexArray_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    backdrop_.copyTo(target);
}

void RasterView::setLights() {
    glm::vec3 positions[kMaxLights], colors[kMaxLights];
    const int count = std::min(static_cast<int>(scene_->lights.size()), kMaxLights);
    for (int i = 0; i < count; ++i) {
        const LightSpot spot = std::visit([](const auto& shape) { return spotOf(shape); },
                                          scene_->lights[static_cast<std::size_t>(i)].shape);
        positions[i] = glm::vec3(scale_ * glm::dvec3(spot.position));
        // Colours far above 1 assume a distance falloff, which this view does not have.
        colors[i] = spot.color / std::max({spot.color.r, spot.color.g, spot.color.b, 1.0f});
    }
    surface_.set("lightCount", count);
    if (count > 0) surface_.set("lightPositions", positions, count);
    if (count > 0) surface_.set("lightColors", colors, count);
}

void RasterView::drawItem(const Item& item, const RasterStyle& style, bool moving) {
    const MeshBuffer& mesh = moving ? item.mesh->proxy() : item.mesh->whole();
    static const Material kNoMaterial;
    const Material& material =
        item.material < scene_->materials.size() ? scene_->materials[item.material] : kNoMaterial;
    const auto texture = textures_.find(material.kdTexture);
    const bool textured = style.textures && texture != textures_.end() && mesh.hasTexCoords();
    const glm::dmat4 toDrawn = glm::scale(glm::dmat4(1.0), glm::dvec3(scale_)) * item.model;
    surface_.set("model", glm::mat4(glm::scale(toDrawn, glm::dvec3(mesh.unit()))));
    surface_.set("normalMatrix", normalMatrix(item.model));
    surface_.set("useNormals", style.smoothNormals && mesh.hasNormals() ? 1 : 0);
    surface_.set("useTexture", textured ? 1 : 0);
    surface_.set("useColors", item.showsColors && mesh.hasColors() ? 1 : 0);
    surface_.set("kd", material.kd);
    surface_.set("ks", material.ks);
    surface_.set("shininess", std::max(material.shininess, 1.0f));
    // Nearly transparent objects stay visible.
    surface_.set("opacity", std::max(material.opacity, 0.15f));
    if (textured) texture->second.bind(0);
    counts_.trianglesDrawn += mesh.draw(item.slot);
    counts_.triangles += item.mesh->whole().trianglesOf(item.slot);
}

DrawnCounts RasterView::draw(const RenderTarget& target, const ViewFrame& frame, const RasterStyle& style,
                             bool moving) {
    counts_ = {};
    drawBackground(target);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (!scene_) return counts_;

    glEnable(GL_DEPTH_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, style.wireframe ? GL_LINE : GL_FILL);
    surface_.use();
    ViewFrame drawn = frame;
    drawn.eye *= scale_;
    const SceneBounds bounds{glm::vec3(scale_ * glm::dvec3(bounds_.lower)),
                             glm::vec3(scale_ * glm::dvec3(bounds_.upper))};
    surface_.set("viewProjection", viewProjection(drawn, bounds));
    surface_.set("eye", glm::vec3(drawn.eye));
    surface_.set("kdTexture", 0);
    setLights();
    for (const Item& item : opaque_) drawItem(item, style, moving);

    const auto distance = [&](const Item& item) { return glm::length(item.center - frame.eye); };
    std::sort(transparent_.begin(), transparent_.end(),
              [&](const Item& a, const Item& b) { return distance(a) > distance(b); });
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const Item& item : transparent_) drawItem(item, style, moving);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    return counts_;
}

}  // namespace rayscope::viewer
