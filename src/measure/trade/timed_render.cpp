#include "measure/trade/timed_render.h"

#include <rayscope/diagnostics.h>

#include <algorithm>

#include "measure/statistics/deadline.h"
#include "post/display_transform.h"
#include "render/pass_plan.h"
#include "render/render_pass.h"

namespace rayscope::measure {

std::optional<TimedRender> renderTimed(render::ThreadArena& workers, const trace::CompileRequest& request,
                                       const trace::World* previous, std::uint64_t seed, double maxSeconds,
                                       const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const Deadline deadline(maxSeconds, stop);
    return workers.run([&]() -> std::optional<TimedRender> {
        std::shared_ptr<const trace::World> world;
        try {
            world = trace::compile(request, previous, deadline.token());
        } catch (const Stopped&) {
            return std::nullopt;
        }
        TimedRender timed;
        const bool reused =
            previous && std::ranges::equal(previous->motionGroups, world->motionGroups, {},
                                           &trace::MotionGroup::accel, &trace::MotionGroup::accel);
        timed.buildSeconds = reused ? 0.0 : world->buildReport.seconds;
        render::Film film(request.width, request.height, {0, request.width, 0, request.height});
        render::RenderCounters counters;
        const int wanted = request.settings.spp;
        const Clock::time_point start = Clock::now();
        for (int done = 0; done < wanted; done = film.completeSamples())
            if (!render::renderPass(*world, seed, film, render::nextPassTarget(done, wanted, false),
                                    {deadline.token(), {}}, counters))
                return std::nullopt;
        try {
            timed.image = post::applyDisplayTransform(film.mean(), request.settings, false, deadline.token());
        } catch (const Stopped&) {
            return std::nullopt;
        }
        timed.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        timed.rays = counters.rays;
        timed.world = std::move(world);
        return timed;
    });
}

}  // namespace rayscope::measure
