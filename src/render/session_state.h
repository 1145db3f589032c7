#pragma once
// The inside of a RenderSession: one thread that serves requests, and what it shares with the caller.
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <rayscope/render_session.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "render/film.h"
#include "render/render_pass.h"

namespace rayscope::render {

using SessionClock = std::chrono::steady_clock;

inline double secondsSince(SessionClock::time_point start) {
    return std::chrono::duration<double>(SessionClock::now() - start).count();
}

}  // namespace rayscope::render

namespace rayscope {

/// One thread runs requests, one at a time. Everything under `lock` is shared with the caller; the caller
/// never waits for more than a copy. `stop` interrupts whatever runs at present.
struct RenderSession::State {
    explicit State(int threads);

    void run();
    void serve(const RenderRequest& request, std::uint64_t epoch, const render::PassControl& control);
    void prepareFilm(const RenderRequest& request);
    bool renderPasses(const RenderRequest& request, const render::PassControl& control);

    oneapi::tbb::global_control parallelism;
    oneapi::tbb::task_arena arena;

    mutable std::mutex lock;
    std::condition_variable changedState;
    std::optional<RenderRequest> pending;
    bool paused = false, quitting = false;
    std::uint64_t epoch = 0;
    std::stop_source stop, drain;
    RenderStatus status;
    std::shared_ptr<const trace::World> world;
    std::shared_ptr<render::Film> film;
    std::optional<RenderRequest> filmRequest;  ///< what the film was made for
    render::RenderCounters counters;
    render::SessionClock::time_point started{};
    double doneAtStart = 0.0;

    // Only collect() uses these.
    std::shared_ptr<render::Film> collectedFilm;
    std::vector<std::uint32_t> collectedVersions;
    int nextTile = 0;

    std::jthread thread;  ///< last, so that everything else outlives it
};

}  // namespace rayscope
