#pragma once
// What the program says if it crashes: what it was rendering, and how to repeat it.
#include <rayscope/render_session.h>
#include <atomic>
#include <string>

#include <rayscope/path.h>

namespace rayscope::render {

/// The command line that traces one sample of a request again: `rayscope probe SCENE …` without the pixel. It
/// names the settings that differ from the defaults, and the camera in full; a lens comes with the name of
/// the camera.
std::string probeCommandOf(const RenderRequest& request);

/// From now on a crash by a signal, or by an assertion that fails, is reported on stderr before the program
/// ends by that signal: the scene, the settings, and for the samples that were being traced the command that
/// repeats them, first that of the thread that crashed. That works also where a thread has used up its stack.
void installCrashReport();

/// What is being rendered, for the report. The latest request wins.
void describeForCrashReport(const RenderRequest& request);

/// The sample that a thread is tracing; asking for it prepares the thread for a report. Written for every
/// sample, read only by the report.
class CurrentSample {
  public:
    static CurrentSample& ofThisThread();

    void set(int x, int y, int index) {
        x_.store(x, std::memory_order_relaxed);
        y_.store(y, std::memory_order_relaxed);
        index_.store(index, std::memory_order_relaxed);
    }
    void clear() { set(0, 0, kNone); }
    bool isBusy() const { return index_.load(std::memory_order_relaxed) != kNone; }
    SampleId name() const {
        return {x_.load(std::memory_order_relaxed), y_.load(std::memory_order_relaxed),
                index_.load(std::memory_order_relaxed)};
    }

  private:
    static constexpr int kNone = -1;
    alignas(64) std::atomic<int> x_{0};
    std::atomic<int> y_{0}, index_{kNone};
};

}  // namespace rayscope::render
