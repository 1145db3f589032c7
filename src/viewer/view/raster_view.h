#pragma once
#include <rayscope/scene.h>
#include <map>
#include <memory>
#include <vector>

#include "viewer/gl/render_target.h"
#include "viewer/gl/shader.h"
#include "viewer/gl/texture.h"
#include "viewer/model/projection.h"
#include "viewer/model/raster_style.h"
#include "viewer/view/drawable_mesh.h"
#include "viewer/view/drawing_budget.h"

namespace rayscope::viewer {

/// Draws the scene with OpenGL and the camera of the tracer, lit by a headlight and by the lights of the
/// scene without shadows.
class RasterView {
  public:
    /// While something moves, at most about this many triangles are drawn.
    explicit RasterView(std::size_t maxTrianglesMoving);
    ~RasterView();
    RasterView(const RasterView&) = delete;
    RasterView& operator=(const RasterView&) = delete;

    /// Creates the OpenGL objects that are new in `scene` and deletes those that it does not have.
    void setScene(std::shared_ptr<const SceneDescription> scene, const SceneBounds& bounds);
    const SceneBounds& bounds() const { return bounds_; }

    /// Fills the target: background, opaque, then transparent surfaces. Counts triangles.
    DrawnCounts draw(const RenderTarget& target, const ViewFrame& frame, const RasterStyle& style,
                     bool moving);

  private:
    /// One thing to draw: the triangles of a slot of a mesh, or a sphere.
    struct Item {
        DrawableMesh* mesh;
        std::uint32_t slot;
        glm::dmat4 model;
        std::size_t material;
        glm::dvec3 center;         ///< of transparent items, which are sorted by distance
        bool showsColors = false;  ///< the vertex colours of the mesh
    };
    void drawBackground(const RenderTarget& target);
    void setLights();
    void drawItem(const Item& item, const RasterStyle& style, bool moving);
    void collectItems();
    void distributeTriangles();

    Shader surface_{"surface"}, background_{"background"};
    std::shared_ptr<const SceneDescription> scene_;
    SceneBounds bounds_;
    double scale_ = 1.0;  ///< from scene units to those that are drawn, see drawingUnit()
    std::map<std::shared_ptr<const MeshData>, std::unique_ptr<DrawableMesh>> meshes_;
    std::map<std::shared_ptr<const Texture>, GlTexture> textures_;
    DrawableMesh sphere_;
    std::vector<Item> opaque_, transparent_;
    RenderTarget backdrop_;
    std::size_t maxTrianglesMoving_;
    DrawnCounts counts_;
    GLuint emptyVertexArray_ = 0;
};

}  // namespace rayscope::viewer
