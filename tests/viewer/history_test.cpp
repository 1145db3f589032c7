#include "viewer/model/history.h"

#include <gtest/gtest.h>

namespace rayscope::viewer {
namespace {

EditState stateWithDepth(int depth) {
    EditState state;
    state.settings.maxDepth = depth;
    return state;
}

TEST(History, undoesAndRedoes) {
    History history(stateWithDepth(0));
    history.record(stateWithDepth(1));
    history.record(stateWithDepth(2));
    EXPECT_EQ(history.undo(), stateWithDepth(1));
    EXPECT_EQ(history.undo(), stateWithDepth(0));
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(history.redo(), stateWithDepth(1));
    EXPECT_EQ(history.redo(), stateWithDepth(2));
    EXPECT_FALSE(history.canRedo());
}

TEST(History, recordsOnlyChanges) {
    History history(stateWithDepth(0));
    history.record(stateWithDepth(0));
    EXPECT_FALSE(history.canUndo());
}

TEST(History, aChangeAfterUndoDiscardsUndoneSteps) {
    History history(stateWithDepth(0));
    history.record(stateWithDepth(1));
    history.undo();
    history.record(stateWithDepth(7));
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.current(), stateWithDepth(7));
    EXPECT_EQ(history.undo(), stateWithDepth(0));
}

TEST(History, includesCameraSettingsAndScene) {
    EditState first;
    first.scene = std::make_shared<const SceneDescription>();
    EditState camera = first, scene = first;
    camera.camera.fov = 20.0f;
    scene.scene = withLights(*first.scene, {Light{PointLight{}}});
    History history(first);
    history.record(camera);
    EXPECT_TRUE(history.canUndo());
    history.record(scene);
    EXPECT_EQ(history.undo().camera.fov, 20.0f);
    EXPECT_TRUE(history.current().scene->lights.empty());
    EXPECT_EQ(history.redo().scene->lights.size(), 1u);
}

TEST(History, discardsTheOldestStepsBeyondItsLimit) {
    History history(stateWithDepth(0));
    for (int i = 1; i < static_cast<int>(History::kMaxStates) + 50; ++i) {
        EditState state;
        state.settings.spp = i + 16;
        history.record(state);
    }
    std::size_t steps = 0;
    for (; history.canUndo(); history.undo()) ++steps;
    EXPECT_EQ(steps, History::kMaxStates - 1);
    EXPECT_EQ(history.current().settings.spp, 50 + 16);
}

TEST(EditState, opensWithTheOverrides) {
    SceneDescription scene;
    scene.cameras.resize(2);
    scene.cameras[1].name = "b";
    scene.settings = {{"max_depth", "2", {}}, {"spp", "4", {}}};
    RequestOverrides overrides;
    overrides.camera.name = "b";
    overrides.settings = {{"spp", "9", {}}};
    const EditState state = initialState(scene, overrides);
    EXPECT_EQ(state.scene->cameras.size(), 2u);
    EXPECT_EQ(state.settings.maxDepth, 2);
    EXPECT_EQ(state.settings.spp, 9);
    EXPECT_EQ(state.camera.name, "b");
}

}  // namespace
}  // namespace rayscope::viewer
