#include "viewer/jobs/debug_rays.h"

#include <algorithm>

#include "probe/names.h"
#include "render/film.h"
#include "trace/world.h"

namespace rayscope::viewer {

namespace {

constexpr std::uint64_t kSeed = 0;  // the window renders with this one

std::size_t bytesOf(const RayTree& tree) {
    return sizeof tree + tree.nodes.size() * sizeof(RayNode) + tree.shadowRays.size() * sizeof(ShadowRay) +
           tree.addends.size() * sizeof(RgbSum);
}

}  // namespace

void DebugRays::shoot(std::shared_ptr<const trace::World> world, const EditState& state, glm::ivec2 imageSize,
                      SampleName name, const render::Film* film) {
    Shot shot;
    // Beside the rasterised view the world is compiled for one sample, which only a jittered grid depends on.
    const bool dependsOnCount = world->settings.sampler == SamplePattern::Jittered;
    shot.samples = dependsOnCount ? world->settings.spp : state.settings.spp;
    shot.state = state;
    shot.imageSize = imageSize;
    shot.trees = {RayTree{}};
    shot.trees[0].name = name;
    if (film != nullptr) shot.verdict = verify(*world, *film, kSeed, name.x, name.y);
    shot.pixel = probe::replayPixel(*world, kSeed, name.x, name.y, std::min(shot.samples, mostSamples));
    shot.statistics = probe::statisticsOf(shot.pixel.values);
    shot.world = std::move(world);
    shot_ = std::move(shot);
    sample_ = name.index;
    record();
}

/// Fills `trees`; the chosen sample is always among them.
void DebugRays::record() {
    Shot& shot = *shot_;
    SampleName name = shot.tree().name;
    shot.trees.clear();
    std::size_t bytes = 0;
    name.index = sample_;
    if (filter.allSamples)
        for (name.index = 0; name.index < shot.samples && bytes < budget; ++name.index) {
            shot.trees.push_back(probeSample(*shot.world, kSeed, name));
            bytes += bytesOf(shot.trees.back());
        }
    if (static_cast<std::size_t>(sample_) < shot.trees.size()) {
        shot.chosen = static_cast<std::size_t>(sample_);
    } else {
        name.index = sample_;
        shot.chosen = shot.trees.size();
        shot.trees.push_back(probeSample(*shot.world, kSeed, name));
    }
    filter.selected = {};
    filter.hidden.clear();
    searched_.reset();
    searches_.clear();
    ++version_;
}

void DebugRays::clear() {
    shot_.reset();
    filter.selected = {};
    filter.hidden.clear();
    searched_.reset();
    searches_.clear();
    ++version_;
}

void DebugRays::chooseSample(int index) {
    if (!shot_) return;
    sample_ = std::clamp(index, 0, std::max(0, shot_->samples - 1));
    record();
}

void DebugRays::showAllSamples(bool all) {
    filter.allSamples = all;
    if (shot_) record();
}

void DebugRays::verifyAgain(const render::Film& film) {
    if (!shot_ || !shot_->verdict) return;
    const SampleName name = shot_->tree().name;
    int samples = 0;
    film.sums(name.x, name.y, samples);
    if (samples != shot_->verdict->samples)
        shot_->verdict = verify(*shot_->world, film, kSeed, name.x, name.y);
}

void DebugRays::select(RaySelection selection) {
    filter.selected = selection;
    ++version_;
}

const std::vector<probe::Explanation>& DebugRays::explain() {
    Shot& shot = *shot_;
    const SampleName name = shot.tree().name;
    if (!shot.explanations)
        shot.explanations =
            probe::explainPixel(*shot.world, kSeed, name.x, name.y,
                                std::min(probe::samplesToExplain(shot.state.settings), shot.samples));
    return *shot.explanations;
}

void DebugRays::show(const probe::Evidence& evidence) {
    chooseSample(evidence.sample);
    select({evidence.node, evidence.shadow});
}

void DebugRays::pin() {
    if (!shot_) return;
    const RayTree& tree = shot_->tree();
    const RayNode& first = tree.nodes.front();
    double rays = 0.0;
    for (const std::uint32_t count : shot_->pixel.rays) rays += count;
    pins.push_back({{tree.name.x, tree.name.y},
                    first.hit ? probe::objectName(*shot_->world, first.object) : "nothing",
                    shot_->statistics.mean,
                    shot_->statistics.errorOfMean(),
                    rays / static_cast<double>(std::max<std::size_t>(shot_->pixel.rays.size(), 1))});
}

void DebugRays::hideSelected() {
    if (filter.selected.empty()) return;
    filter.hidden.push_back(filter.selected);
    filter.selected = {};
}

void DebugRays::updateSearch() {
    const bool isKnown = searched_ == filter.selected && searchedLayout_ == search.layout;
    if (!shot_ || !search.shown || isKnown) return;
    const RayTree& tree = shot_->tree();
    searched_ = filter.selected;
    searchedLayout_ = search.layout;
    if (filter.selected.shadow >= 0) {
        const ShadowRay& shadow = tree.shadowRays[static_cast<std::size_t>(filter.selected.shadow)];
        searches_ = probe::recordAnyHit(*shot_->world, shadow.ray, tree.time, search.layout);
    } else {
        const auto node = static_cast<std::size_t>(std::max(filter.selected.node, 0));
        searches_ = probe::recordClosestHit(*shot_->world, tree.nodes[node].ray, tree.time, search.layout);
    }
    ++version_;
}

void DebugRays::step(int by) {
    search.shown = search.stepping = true;
    updateSearch();
    std::size_t most = 0;
    for (const probe::TraversalLog& log : searches_) most = std::max(most, log.steps.size());
    search.step = std::clamp(search.step + by, 0, static_cast<int>(most));
}

bool DebugRays::staleFor(const EditState& state, glm::ivec2 imageSize) const {
    return shot_ && (shot_->state.scene != state.scene || shot_->state.camera != state.camera ||
                     shot_->imageSize != imageSize ||
                     changed(shot_->state.settings, state.settings) > Invalidates::Display);
}

}  // namespace rayscope::viewer
