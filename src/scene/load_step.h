#pragma once
#include <rayscope/scene.h>

#include <cstddef>
#include <string>

namespace rayscope::scene {

/// One step of loading, e.g. reading one file: reports its progress, and throws Stopped on a stop request and
/// OutOfMemory when memory runs out.
class LoadStep {
  public:
    /// `total`: the amount of work, in any unit that advanceTo() uses; 0 if it is unknown. `control` must
    /// outlive the step.
    LoadStep(const LoadControl& control, std::string name, std::size_t total);

    /// To be called often, e.g. once per line; costs a comparison except about 250 times per step.
    void advanceTo(std::size_t done) {
        done_ = done;
        if (done >= next_) report(done);
    }
    /// The same for one more unit of work.
    void advance() { advanceTo(done_ + 1); }

  private:
    void report(std::size_t done);

    const LoadControl& control_;
    std::string name_;
    std::size_t total_, interval_, done_ = 0, next_ = 0;
    unsigned reports_ = 0;
};

/// A control whose steps are called "PREFIX: STEP". `control` must outlive it.
LoadControl withPrefix(const LoadControl& control, std::string prefix);

}  // namespace rayscope::scene
