// What the commands of the menus Rays and BVH do.
#include <utility>

#include "viewer/application.h"

namespace rayscope::viewer {

void Application::carryOutDebugging(Command command) {
    BvhInspector& bvh = workspace_.bvh;
    switch (command) {
        case Command::ToggleBvhLevels:
            bvh.shown.levels = !bvh.shown.levels;
            break;
        case Command::DeeperLevel:
            bvh.stepLevel(1);
            break;
        case Command::HigherLevel:
            bvh.stepLevel(-1);
            break;
        case Command::NextLeaf:
            bvh.stepLeaf(1);
            break;
        case Command::PreviousLeaf:
            bvh.stepLeaf(-1);
            break;
        case Command::LeafUnderCursor:
            cursorCommands_.push_back(command);
            break;
        default:
            break;
    }
}

/// Once it is known what the cursor is on: it may have moved in the same frame in which the key went down.
void Application::carryOutAtCursor() {
    for (const Command command : std::exchange(cursorCommands_, {})) {
        if (!workspace_.cursor) continue;
        const CursorInfo& cursor = *workspace_.cursor;
        if (command == Command::LeafUnderCursor && cursor.primitive != kNoPrimitive)
            workspace_.bvh.selectLeafOf(workspace_.render.session().world()->nameOf(cursor.primitive).inBody);
    }
    if (rayWanted_) shootRay();
}

}  // namespace rayscope::viewer
