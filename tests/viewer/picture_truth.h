#pragma once
// What labels of pictures claim, computed independently.
#include <string>

#include "support/temporary_folder.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// The mean of the first samples of a pixel, computed from the request alone.
Rgb trueMean(const RenderRequest& request, int x, int y, int samples);

bool haveSameBits(const Rgb& a, const Rgb& b);

/// The state and the size of a picture when it was saved.
struct SavedState {
    EditState state;
    glm::ivec2 size;
};
/// Expects the metadata of the file to be those of the state, and its pixels those of a render of the state
/// and those of the command in its metadata. Returns whether there is one.
bool checkSavedFile(const std::string& path, const SavedState& saved, const test::TemporaryFolder& folder);

}  // namespace rayscope::viewer
