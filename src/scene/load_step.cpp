#include "scene/load_step.h"

#include <algorithm>

#include "base/memory_budget.h"

namespace rayscope::scene {

LoadStep::LoadStep(const LoadControl& control, std::string name, std::size_t total)
    : control_(control), name_(std::move(name)), total_(total), interval_(total / 250 + 1) {
    report(0);
}

void LoadStep::report(std::size_t done) {
    if (control_.stop.stop_requested()) throw Stopped();
    // Without a total every unit of work is reported, too often for a look at the memory.
    constexpr unsigned kReportsPerLook = 256;
    if (total_ > 0 || reports_++ % kReportsPerLook == 0) base::requireSomeMemory(name_, "a smaller scene");
    const double fraction = total_ == 0 ? 0.0 : static_cast<double>(done) / static_cast<double>(total_);
    if (control_.progress) control_.progress(name_, std::min(1.0, fraction));
    next_ = done + interval_;
}

LoadControl withPrefix(const LoadControl& control, std::string prefix) {
    LoadControl prefixed{.progress = {}, .stop = control.stop};
    if (control.progress)
        prefixed.progress = [&control, prefix = std::move(prefix)](const std::string& step, double fraction) {
            control.progress(prefix + ": " + step, fraction);
        };
    return prefixed;
}

}  // namespace rayscope::scene
