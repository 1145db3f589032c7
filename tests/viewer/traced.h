#pragma once
// Pictures that a session has traced to the end, for tests.
#include <gtest/gtest.h>
#include <rayscope/render_session.h>

#include "support/environments.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

inline TracedPicture traced(const RenderRequest& request) {
    RenderSession session(1);
    session.submit(request);
    EXPECT_EQ(session.wait(60.0), RenderState::Done);
    return *session.picture();
}

inline TracedPicture traced(const EditState& state, glm::ivec2 size) {
    return traced(requestOf(state, size.x, size.y));
}

/// A picture whose pixels all have this value.
inline StillPicture flatPicture(int width, int height, float value) {
    SceneDescription scene;
    scene.environment = test::cubeOf(1, [&](const glm::dvec3&) { return Rgb(value); });
    RenderRequest request;
    request.scene = std::make_shared<const SceneDescription>(std::move(scene));
    request.settings.spp = 1;
    request.width = width;
    request.height = height;
    return traced(request).still();
}

}  // namespace rayscope::viewer
