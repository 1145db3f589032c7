#include "render/probe_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/scene.h>

namespace rayscope {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

RenderRequest cornell() {
    Diagnostics notes;
    RenderRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene("builtin:cornell", notes));
    for (const SettingAssignment& assignment : request.scene->settings)
        assign(request.settings, assignment.key, assignment.value);
    request.camera = request.scene->cameras.front();
    request.width = 40;
    request.height = 30;
    return request;
}

TEST(ProbeCommand, OmitsEverythingThatTheSceneSets) {
    EXPECT_EQ(render::probeCommand(cornell(), {12, 3, 5}),
              "rayscope probe builtin:cornell --size 40x30 --pixel 12,3 --sample 5");
}

TEST(ProbeCommand, NamesSeedSettingsAndCameraThatDiffer) {
    RenderRequest request = cornell();
    request.seed = 7;
    request.settings.hardShadows = false;
    request.settings.exposure = 1.5f;
    request.camera.lookFrom = {1, 2, 3.5f};
    request.camera.fov = 30.0f;
    const std::string command = render::probeCommand(request, {0, 0, 0});
    for (const char* option : {" --seed 7", " --set hard_shadows=false", " --set exposure=1.5",
                               " --look-from 1,2,3.5", " --fov 30"})
        EXPECT_THAT(command, HasSubstr(option));
    EXPECT_THAT(command, Not(HasSubstr("--look-at")));
}

TEST(ProbeCommand, NamesACameraOtherThanTheFirst) {
    RenderRequest request = cornell();
    SceneDescription scene = *request.scene;
    CameraDescription side = request.camera;
    side.name = "side view";
    side.lookFrom.x += 1.0f;
    scene.cameras.push_back(side);
    request.camera = side;
    request.scene = std::make_shared<const SceneDescription>(scene);
    EXPECT_THAT(render::probeCommand(request, {0, 0, 0}), HasSubstr(" --camera 'side view' --pixel"));
}

/// The settings of a command, applied to those of the scene, are those of the request.
TEST(ProbeCommand, ReproducesEveryPreset) {
    for (const Preset& preset : presets()) {
        RenderRequest request = cornell();
        const Settings ofScene = request.settings;
        applyPreset(request.settings, preset, false);
        const std::string command = render::probeCommand(request, {0, 0, 0});
        Settings repeated = ofScene;
        const std::string option = " --set ";
        for (std::size_t at = command.find(option); at != std::string::npos; at = command.find(option, at)) {
            at += option.size();
            const std::string text = command.substr(at, command.find(' ', at) - at);
            const std::size_t equals = text.find('=');
            assign(repeated, text.substr(0, equals), text.substr(equals + 1));
        }
        EXPECT_EQ(repeated, request.settings) << preset.name;
        EXPECT_NE(repeated, ofScene) << preset.name;
    }
}

TEST(ProbeCommand, IsThatOfTheCrashReport) {
    const RenderRequest request = cornell();
    const render::CrashContext context = render::crashContextOf(request);
    EXPECT_EQ(context.beforeX + "12" + context.beforeY + "3" + context.beforeIndex + "5",
              render::probeCommand(request, {12, 3, 5}));
    EXPECT_THAT(context.scene, EndsWith("40 x 30 pixels, seed 0"));
}

}  // namespace
}  // namespace rayscope
