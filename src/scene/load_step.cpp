#include "scene/load_step.h"

#include <algorithm>

namespace rayscope::scene {

LoadStep::LoadStep(const LoadControl& control, std::string name, std::size_t total)
    : control_(control),
      name_(std::move(name)),
      total_(std::max<std::size_t>(total, 1)),
      interval_(total / 250 + 1) {
    report(0);
}

void LoadStep::report(std::size_t done) {
    if (control_.stop.stop_requested()) throw Stopped();
    if (control_.progress)
        control_.progress(name_, std::min(1.0, static_cast<double>(done) / static_cast<double>(total_)));
    next_ = done + interval_;
}

}  // namespace rayscope::scene
