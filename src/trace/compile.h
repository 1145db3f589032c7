#pragma once
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <memory>
#include <stop_token>

#include "trace/world.h"

namespace rayscope::trace {

/// The input of compile().
struct CompileRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    int width = 1, height = 1;
    bool keepBinaryTrees = true;  ///< for display and recorded traversal; rays do not need them
};

/// The part of the settings that describes how BVHs are built.
BuildSettings buildSettingsOf(const Settings& settings, std::stop_token stop = {});

/// Compiles a scene description into a world. What did not change since `previous` (which may be null) is
/// shared with it, so that moving a light or the camera rebuilds no BVH. Throws Stopped if a stop is
/// requested, InputError if the scene cannot be traced, and std::invalid_argument if it is invalid, see
/// checkDescription().
std::shared_ptr<const World> compile(const CompileRequest& request, const World* previous = nullptr,
                                     std::stop_token stop = {});

}  // namespace rayscope::trace
