#pragma once
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <memory>
#include <stop_token>

#include "trace/world.h"

namespace rayscope::trace {

/// What a world is made from.
struct CompileRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    int width = 1, height = 1;
    bool keepBinaryTrees = true;  ///< for looking at and walking step by step; rays do not need them
};

/// How the settings ask hierarchies to be built.
BuildSettings buildSettingsOf(const Settings& settings, std::stop_token stop = {});

/// Makes a description ready to trace. What did not change since `previous` (which may be null) is shared
/// with it, so that moving a light or the camera costs nothing. Throws Stopped when asked to stop, InputError
/// if a scene cannot be traced.
std::shared_ptr<const World> compile(const CompileRequest& request, const World* previous = nullptr,
                                     std::stop_token stop = {});

}  // namespace rayscope::trace
