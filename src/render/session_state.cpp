#include "render/session_state.h"

#include <new>

#include "base/memory_budget.h"
#include "render/pass_plan.h"
#include "render/probe_command.h"
#include "sampling/sample_stream.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

PixelBounds regionOf(const RenderRequest& request) {
    const PixelBounds whole{0, request.width, 0, request.height};
    return request.region.value_or(whole);
}

/// Whether the samples of a picture are also the first samples of `after`, and not more than it asks for.
bool continues(const TracedPicture& picture, const RenderRequest& after) {
    if (picture.film()->mostSamples() > after.settings.spp) return false;
    const RenderRequest& before = picture.request();
    Settings sameCount = before.settings;
    if (!sampling::dependsOnSampleCount(after.settings.sampler)) sameCount.spp = after.settings.spp;
    return before.scene == after.scene && before.camera == after.camera && before.width == after.width &&
           before.height == after.height && regionOf(before) == regionOf(after) &&
           before.seed == after.seed && changed(sameCount, after.settings) <= Invalidates::Display;
}

/// The images that are made of a film: its mean, what is shown or written of it, and copies of bloom.
std::uint64_t imagesOf(const RenderRequest& request) { return request.settings.bloom ? 5 : 3; }

}  // namespace

void RenderSession::State::run() {
    for (;;) {
        RenderRequest request;
        std::uint64_t number = 0;
        render::PassControl control;
        {
            std::unique_lock guard(lock);
            changedState.wait(guard, [&] { return quitting || (pending && !paused); });
            if (quitting) return;
            request = std::move(*pending);
            pending.reset();
            number = epoch;
            stop = std::stop_source{};
            drain = std::stop_source{};
            control = {stop.get_token(), drain.get_token()};
            status.state = RenderState::Compiling;
            status.message.clear();
        }
        serve(request, number, control);
    }
}

void RenderSession::State::serve(const RenderRequest& request, std::uint64_t number,
                                 const render::PassControl& control) {
    RenderState outcome = RenderState::Idle;
    std::string message;
    bool isOutOfMemory = false;
    try {
        render::setCrashContext(render::crashContextOf(request));
        const render::SessionClock::time_point start = render::SessionClock::now();
        const trace::World* const previous = picture ? picture->world().get() : nullptr;
        std::shared_ptr<const trace::World> compiled;
        arena.run([&] {
            compiled = trace::compile({request.scene, request.settings, request.camera, request.width,
                                       request.height, request.keepBinaryTrees},
                                      previous, control.stop);
        });
        {
            const std::scoped_lock guard(lock);
            status.compileSeconds = render::secondsSince(start);
            status.buildSeconds = compiled->buildReport.seconds;
            status.sahCostGrowth = compiled->buildReport.sahCostGrowth;
        }
        preparePicture(request, std::move(compiled));
        if (renderPasses(request, control)) outcome = RenderState::Done;
    } catch (const Stopped&) {
        // Cancelled, paused or replaced: the state below follows from `pending` and `paused`.
    } catch (const std::bad_alloc& error) {
        outcome = RenderState::Failed;
        isOutOfMemory = true;
        message = base::messageOf(error);
    } catch (const std::exception& error) {
        outcome = RenderState::Failed;
        message = error.what();
    }
    const std::scoped_lock guard(lock);
    // A paused request stays pending, unless a newer one replaces it.
    if (outcome == RenderState::Idle && paused && !pending && number == epoch && !quitting) pending = request;
    if (pending) outcome = paused ? RenderState::Paused : RenderState::Compiling;
    status.state = outcome;
    status.message = std::move(message);
    status.outOfMemory = isOutOfMemory;
    changedState.notify_all();
}

void RenderSession::State::preparePicture(const RenderRequest& request,
                                          std::shared_ptr<const trace::World> world) {
    const std::scoped_lock guard(lock);
    if (!picture || !continues(*picture, request)) {
        picture.reset();
        film.reset();
        // Now, rather than after the render.
        render::Film::requireMemory(regionOf(request), 1, imagesOf(request));
        film = std::make_shared<render::Film>(request.width, request.height, regionOf(request));
        counters.rays = 0;
        counters.nonFiniteSamples = 0;
        status.elapsedSeconds = 0.0;
    }
    picture = TracedPicture(request, std::move(world), film);
    status.state = RenderState::Rendering;
    status.targetSamples = request.settings.spp;
    started = render::SessionClock::now();
    doneAtStart = film->doneFraction(request.settings.spp);
}

bool RenderSession::State::renderPasses(const RenderRequest& request, const render::PassControl& control) {
    const int wanted = request.settings.spp;
    bool complete = true;
    for (int samples = film->completeSamples(); complete && samples < wanted;
         samples = film->completeSamples()) {
        const int target = render::nextPassTarget(samples, wanted, request.progressive);
        arena.run([&] {
            complete = render::renderPass(*picture->world(), request.seed, *film, target, control, counters);
        });
    }
    const std::scoped_lock guard(lock);
    status.elapsedSeconds += render::secondsSince(started);
    return complete;
}

}  // namespace rayscope
