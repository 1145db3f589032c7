#pragma once
#include <rayscope/scene.h>
#include <map>
#include <memory>
#include <vector>

#include "viewer/gl/mesh_buffer.h"
#include "viewer/gl/shader.h"
#include "viewer/gl/texture.h"
#include "viewer/projection.h"

namespace rayscope::viewer {

struct RasterStyle {
    bool smoothNormals = true;
    bool textures = true;
    bool wireframe = false;
    bool operator==(const RasterStyle&) const = default;
};

/// Draws the scene with OpenGL through the camera of the tracer: a light at the viewer's side and the lights
/// of the scene without shadows, so that shapes read.
class RasterView {
  public:
    RasterView();
    ~RasterView();
    RasterView(const RasterView&) = delete;
    RasterView& operator=(const RasterView&) = delete;

    /// Loads what is new in `scene` into the graphics card and forgets what is gone.
    void setScene(std::shared_ptr<const SceneDescription> scene);
    const SceneBounds& bounds() const { return bounds_; }

    /// Draws over the bound target: background, opaque, then transparent surfaces.
    void draw(const ViewFrame& frame, const RasterStyle& style);

  private:
    /// One thing to draw: a range of a mesh, or a sphere.
    struct Item {
        const MeshBuffer* mesh;
        MeshBuffer::Range range;
        glm::mat4 model;
        std::size_t material;
        glm::vec3 center;
    };
    void drawBackground();
    void setLights();
    void drawItem(const Item& item, const RasterStyle& style);
    void collectItems();

    Shader surface_{"surface"}, background_{"background"};
    std::shared_ptr<const SceneDescription> scene_;
    SceneBounds bounds_;
    std::map<std::shared_ptr<const MeshData>, std::unique_ptr<MeshBuffer>> meshes_;
    std::map<std::shared_ptr<const Texture>, GlTexture> textures_;
    std::unique_ptr<MeshBuffer> sphere_;
    std::vector<Item> opaque_, transparent_;
    GLuint emptyVertexArray_ = 0;
};

}  // namespace rayscope::viewer
