#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <memory>

#include "viewer/viewer.h"

namespace rayscope::viewer {

/// Everything that a user can edit and undo, as one value. The scene is never changed in place: an edit makes
/// a new one, so states can be compared by address and copies share meshes and textures.
struct EditState {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    bool operator==(const EditState&) const = default;
};

/// The state in which a scene opens: its own settings, then the preset (if any) and the given settings, and
/// its first camera unless `camera` says otherwise. Throws InputError if a setting is wrong or there is no
/// preset or camera of that name.
EditState initialState(SceneDescription scene, const std::vector<SettingAssignment>& settings,
                       const CameraOverrides& camera, const std::string& preset = {});

/// The same scene with other lights.
std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights);

}  // namespace rayscope::viewer
