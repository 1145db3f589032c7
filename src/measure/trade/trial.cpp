#include "measure/trade/trial.h"

#include <rayscope/diagnostics.h>

#include "post/display_transform.h"
#include "render/pass_plan.h"
#include "render/render_pass.h"

namespace rayscope::measure {

std::optional<Trial> runTrial(Workers& workers, const trace::CompileRequest& request,
                              const trace::World* previous, std::uint64_t seed, double maxSeconds,
                              const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const Deadline deadline(maxSeconds, stop);
    return workers.run([&]() -> std::optional<Trial> {
        std::shared_ptr<const trace::World> world;
        try {
            world = trace::compile(request, previous, deadline.token());
        } catch (const Stopped&) {
            return std::nullopt;
        }
        Trial trial;
        trial.buildSeconds = world->buildReport.seconds;
        render::Film film(request.width, request.height, {0, request.width, 0, request.height});
        render::RenderCounters counters;
        const int wanted = request.settings.spp;
        const Clock::time_point start = Clock::now();
        for (int done = 0; done < wanted; done = film.completeSamples())
            if (!render::renderPass(*world, seed, film, render::nextPassTarget(done, wanted, false),
                                    {deadline.token(), {}}, counters))
                return std::nullopt;
        trial.image = post::develop(film.mean(), request.settings, false);
        trial.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        trial.rays = counters.rays;
        trial.world = std::move(world);
        return trial;
    });
}

}  // namespace rayscope::measure
