#pragma once
// Opens scene files as render requests, and defines which source of a setting overrides which.
#include <rayscope/render_session.h>
#include <rayscope/scene.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// Selects a camera of the scene and overrides parts of it; absent members keep the values of the scene.
struct CameraOverrides {
    std::string name;  ///< of a camera of the scene; empty: the first, or a framing camera if it has none
    std::optional<glm::vec3> lookFrom, lookAt, up;
    std::optional<float> fov;  ///< vertical, degrees
    std::optional<Lens> lens;
};

/// Values that override those of the scene file.
struct RequestOverrides {
    CameraOverrides camera;
    std::string preset;                       ///< a name that presetNamed() accepts; empty: none
    std::vector<SettingAssignment> settings;  ///< override the preset
    std::optional<int> spp;                   ///< samples per pixel; overrides `settings`
    int width = 800, height = 800;            ///< of the image, in pixels
    std::uint64_t seed = 0;
};

/// The camera as options of the command line: "--look-from 0,0,3 --look-at 0,0,0 --up 0,1,0 --fov 50", with a
/// lens also "--lens 2.8,0.05,3". The numbers are the shortest that give the same float.
std::string toOptions(const CameraDescription& camera);

/// Sets the values that the options in `text` name and keeps the others. Throws InputError with the expected
/// form.
CameraDescription withOptions(const CameraDescription& camera, std::string_view text);

/// Throws InputError if a setting or the preset is unknown, or a value is out of range.
void checkOverrides(const RequestOverrides& overrides);

/// The request that renders the scene. Sources of settings, of which later ones override earlier ones: the
/// defaults, the scene, the preset, `overrides.settings`, `overrides.spp`. Throws InputError like
/// checkOverrides(), for an unknown camera, and if the position of the camera equals its look-at point or its
/// `up` is zero or parallel to the view.
RenderRequest requestFor(std::shared_ptr<const SceneDescription> scene,
                         const RequestOverrides& overrides = {});

/// Opens a scene (a .toml file, a mesh file or "builtin:NAME") and returns requestFor() of it. Notes and
/// warnings of loadScene() are appended to `notes`. Throws InputError, and Stopped.
RenderRequest openRequest(const std::string& scene, const RequestOverrides& overrides, Diagnostics& notes,
                          const LoadControl& control = {});

}  // namespace rayscope
