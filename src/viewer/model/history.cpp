#include "viewer/model/history.h"

namespace rayscope::viewer {

bool History::record(const EditState& state) {
    if (state == current()) return false;
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(current_ + 1), states_.end());
    states_.push_back(state);
    if (states_.size() > kMaxStates) {
        states_.erase(states_.begin());
        ++dropped_;
    }
    current_ = states_.size() - 1;
    return true;
}

}  // namespace rayscope::viewer
