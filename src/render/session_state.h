#pragma once
// Implementation of RenderSession: one thread that serves requests, and the state that it shares with the
// caller.
#include <rayscope/render_session.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "render/film.h"
#include "render/render_pass.h"
#include "render/thread_arena.h"

namespace rayscope::render {

using SessionClock = std::chrono::steady_clock;

inline double secondsSince(SessionClock::time_point start) {
    return std::chrono::duration<double>(SessionClock::now() - start).count();
}

}  // namespace rayscope::render

namespace rayscope {

/// One thread runs requests, one at a time. Everything below `lock` is shared with the caller and held only
/// for copies, so that the caller never blocks on rendering. `stop` interrupts the current request.
struct RenderSession::State {
    explicit State(int threads) : arena(threads) {}

    void run();
    void serve(const RenderRequest& request, std::uint64_t epoch, const render::PassControl& control);
    void preparePicture(const RenderRequest& request, std::shared_ptr<const trace::World> world);
    bool renderPasses(const RenderRequest& request, const render::PassControl& control);

    render::ThreadArena arena;

    mutable std::mutex lock;
    std::condition_variable changedState;
    std::optional<RenderRequest> pending;
    bool paused = false, quitting = false;
    std::uint64_t epoch = 0;
    std::stop_source stop, drain;
    RenderStatus status;
    std::shared_ptr<render::Film> film;  ///< of `picture`, for the passes
    std::optional<TracedPicture> picture;
    render::RenderCounters counters;
    render::SessionClock::time_point started{};
    double doneAtStart = 0.0;

    // Used by collect() only.
    std::shared_ptr<const render::Film> collectedFilm;
    std::vector<std::uint32_t> collectedVersions;
    int nextTile = 0;

    std::jthread thread;  ///< last member: joined before the others are destroyed
};

}  // namespace rayscope
