#pragma once
#include <cstddef>
#include <vector>

#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// Undo and redo as a list of whole states. A gesture (a drag, typing into a field) becomes one step, because
/// states are recorded only when it has ended.
class History {
  public:
    explicit History(EditState first) : states_{std::move(first)} {}

    /// Records `state` as a new step unless it is the present one. What was undone is forgotten.
    void record(const EditState& state);

    bool canUndo() const { return present_ > 0; }
    bool canRedo() const { return present_ + 1 < states_.size(); }
    /// The state before or after the present one, which becomes the present one; only if canUndo(),
    /// canRedo().
    const EditState& undo() { return states_[--present_]; }
    const EditState& redo() { return states_[++present_]; }
    const EditState& present() const { return states_[present_]; }

    static constexpr std::size_t kMostStates = 500;

  private:
    std::vector<EditState> states_;
    std::size_t present_ = 0;
};

}  // namespace rayscope::viewer
