#include "cli/part_options.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include "cli/command_line.h"
#include "measure/parts/film_part.h"
#include "measure/trade/content_hash.h"
#include "render/pass_plan.h"
#include "render/render_pass.h"
#include "render/thread_arena.h"
#include "trace/compile.h"

namespace rayscope::cli {

void PartOptions::addTo(OptionList& list) {
    list.add("--part", &part, "Render only the tiles of part K of N, for 'rayscope merge'")
        .form("K/N", '/')
        .from(1, 1 << 20);
    list.add("--part-file", &file, "The file that --part writes, instead of an image")
        .writes(Option::Output::File);
}

void PartOptions::check() const {
    if (!part && !file.empty()) throw UsageError("--part-file", "needs --part K/N");
    if (!part) return;
    if (file.empty()) throw UsageError("--part", "needs --part-file FILE");
    if ((*part)[0] > (*part)[1])
        throw UsageError("--part", fmt::format("there is no part {} of {}", (*part)[0], (*part)[1]));
}

void renderPart(const RenderRequest& request, const PartOptions& options, int threads, ProgressStyle style,
                const std::stop_token& stop) {
    const PixelBounds region = request.region.value_or(PixelBounds{0, request.width, 0, request.height});
    const trace::CompileRequest compile{request.scene, request.settings, request.camera,
                                        request.width, request.height,   request.keepBinaryTrees};
    const int wanted = request.settings.spp;
    Progress progress(style);
    render::ThreadArena arena(threads);
    arena.run([&] {
        const auto world = trace::compile(compile, nullptr, stop);
        const measure::FilmPartHeader header{measure::filmContentHash(compile, *world),
                                             request.seed,
                                             wanted,
                                             request.width,
                                             request.height,
                                             region,
                                             (*options.part)[0],
                                             (*options.part)[1]};
        render::Film::requireMemory(region, 1);
        render::Film film(request.width, request.height, region);
        std::vector<int> targets(static_cast<std::size_t>(film.tileCount()), 0);
        render::RenderCounters counters;
        for (int done = 0; done < wanted;) {
            done = render::nextPassTarget(done, wanted, false);
            for (int tile = 0; tile < film.tileCount(); ++tile)
                if (header.contains(tile)) targets[static_cast<std::size_t>(tile)] = done;
            if (!render::renderPass(*world, request.seed, film, targets, {stop, {}}, counters))
                throw Stopped();
            const double fraction = static_cast<double>(done) / wanted;
            progress.show(
                {fraction, fmt::format("{} of {} samples", done, wanted), {{"progress", fraction}}});
        }
        measure::saveFilmPart(options.file, header, film);
    });
    progress.keep();
}

}  // namespace rayscope::cli
