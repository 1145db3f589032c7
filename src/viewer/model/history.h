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

    /// Records `state` as a new step unless it is the current one. Undone states are discarded. Returns
    /// whether there is a new step.
    bool record(const EditState& state);

    bool canUndo() const { return current_ > 0; }
    bool canRedo() const { return current_ + 1 < states_.size(); }
    /// The state before or after the current one, which becomes the current one; only if canUndo(),
    /// canRedo().
    const EditState& undo() { return states_[--current_]; }
    const EditState& redo() { return states_[++current_]; }
    const EditState& current() const { return states_[current_]; }
    /// The number of the current step, counted from the first one that was ever recorded.
    std::size_t position() const { return dropped_ + current_; }

    static constexpr std::size_t kMaxStates = 500;

  private:
    std::vector<EditState> states_;
    std::size_t current_ = 0;
    std::size_t dropped_ = 0;  ///< the oldest steps, beyond kMaxStates
};

}  // namespace rayscope::viewer
