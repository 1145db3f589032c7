#include "viewer/model/history.h"

namespace rayscope::viewer {

void History::record(const EditState& state) {
    if (state == present()) return;
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(present_ + 1), states_.end());
    states_.push_back(state);
    if (states_.size() > kMostStates) states_.erase(states_.begin());
    present_ = states_.size() - 1;
}

}  // namespace rayscope::viewer
