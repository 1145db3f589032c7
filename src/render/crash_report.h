#pragma once
// The report on stderr when the program crashes: what it was rendering, and the command that repeats it.
#include <rayscope/path.h>

#include <atomic>
#include <string>

namespace rayscope::render {

/// The work in progress, as text. The command that repeats a sample is the concatenation of `beforeX`, the
/// pixel's x, `beforeY`, its y, `beforeIndex` and the index of the sample. Long texts are cut.
struct CrashContext {
    std::string scene, settings;
    std::string beforeX, beforeY, beforeIndex;
};

/// Installs signal handlers. From then on a crash by a signal, also by a failed assertion, is reported before
/// the program ends by that signal: the context, and the command of each sample in flight, first that of the
/// thread that crashed. This works also after a stack overflow.
void installCrashReport();

/// Replaces the context of the report. May be called from any thread.
void setCrashContext(const CrashContext& context);

/// The sample that a thread traces. Written for every sample, read only by the report.
class CurrentSample {
  public:
    /// The first call in a thread also gives its signal handlers a stack of their own.
    static CurrentSample& ofThisThread();

    void set(const SampleId& sample) {
        x_.store(sample.x, std::memory_order_relaxed);
        y_.store(sample.y, std::memory_order_relaxed);
        index_.store(sample.index, std::memory_order_relaxed);
    }
    void clear() { set({0, 0, kNone}); }
    bool isSet() const { return index_.load(std::memory_order_relaxed) != kNone; }
    SampleId get() const {
        return {x_.load(std::memory_order_relaxed), y_.load(std::memory_order_relaxed),
                index_.load(std::memory_order_relaxed)};
    }

  private:
    static constexpr int kNone = -1;
    alignas(64) std::atomic<int> x_{0};
    std::atomic<int> y_{0}, index_{kNone};
};

}  // namespace rayscope::render
