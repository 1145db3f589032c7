#pragma once
#include <rayscope/open_request.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <memory>
#include <optional>
#include <vector>

namespace rayscope::viewer {

/// Everything that a user can edit and undo, as one value. The scene is never changed in place: an edit makes
/// a new one, so states can be compared by address and copies share meshes and textures.
struct EditState {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    SceneBounds bounds{};  ///< of the scene
    bool operator==(const EditState&) const = default;
};

/// The state in which a scene opens, as requestFor() gives it. Throws InputError. Without `bounds` those of
/// the scene are computed.
EditState initialState(SceneDescription scene, const RequestOverrides& overrides = {},
                       const std::optional<SceneBounds>& bounds = std::nullopt);

/// The request that renders the state, with the seed of the window.
RenderRequest requestOf(const EditState& state, int width, int height);

/// Whether both show the same from the same camera, whatever their size, number of samples and display.
bool isSameView(const RenderRequest& a, const RenderRequest& b);
bool isSameView(const RenderRequest& a, const EditState& b);
/// Whether they also have the same size.
bool isSameFrame(const RenderRequest& a, const RenderRequest& b);

/// The request of `full` with a fraction of its pixels and one sample of each: 1/divisor in both directions.
RenderRequest previewOf(const RenderRequest& full, int divisor);
inline constexpr int kCoarsestDivisor = 64;
/// The divisor, 1 to kCoarsestDivisor, with which `preview` shows the same as `full`; nothing if it shows
/// another view.
std::optional<int> previewDivisor(const RenderRequest& preview, const RenderRequest& full);

/// The scene with the camera and the settings of the state. It opens in this state if the camera is its
/// first.
SceneDescription sceneOf(const EditState& state);

/// The same scene with other lights, marked as edited.
std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights);

}  // namespace rayscope::viewer
