#include "viewer/jobs/debug_rays.h"

#include <algorithm>

#include "probe/names.h"
#include "render/film.h"
#include "sampling/sample_stream.h"
#include "trace/world.h"

namespace rayscope::viewer {

namespace {

constexpr std::uint64_t kSeed = 0;  // the window renders with this one

std::size_t bytesOf(const RayTree& tree) {
    return sizeof tree + tree.nodes.size() * sizeof(RayNode) + tree.shadowRays.size() * sizeof(ShadowRay) +
           tree.addends.size() * sizeof(RgbSum);
}

}  // namespace

void DebugRays::recordPixel(std::shared_ptr<const trace::World> world, const EditState& state,
                            glm::ivec2 imageSize, SampleId name, const render::Film* film) {
    PixelRecording recording;
    // Beside the rasterised view the world is compiled for one sample per pixel.
    recording.samples =
        sampling::dependsOnSampleCount(world->settings.sampler) ? world->settings.spp : state.settings.spp;
    recording.state = state;
    recording.imageSize = imageSize;
    recording.trees = {RayTree{}};
    recording.trees[0].name = name;
    if (film != nullptr) recording.verdict = verifyReplay(*world, *film, kSeed, name.x, name.y);
    recording.pixel =
        probe::replayPixel(*world, kSeed, name.x, name.y, std::min(recording.samples, maxSamples));
    recording.statistics = probe::statisticsOf(recording.pixel.values);
    recording.world = std::move(world);
    recording_ = std::move(recording);
    sample_ = name.index;
    record();
}

/// Fills `trees`; the chosen sample is always among them.
void DebugRays::record() {
    PixelRecording& recording = *recording_;
    SampleId name = recording.tree().name;
    recording.trees.clear();
    std::size_t bytes = 0;
    name.index = sample_;
    if (filter.allSamples)
        for (name.index = 0; name.index < recording.samples && bytes < budget; ++name.index) {
            recording.trees.push_back(probeSample(*recording.world, kSeed, name));
            bytes += bytesOf(recording.trees.back());
        }
    if (static_cast<std::size_t>(sample_) < recording.trees.size()) {
        recording.chosen = static_cast<std::size_t>(sample_);
    } else {
        name.index = sample_;
        recording.chosen = recording.trees.size();
        recording.trees.push_back(probeSample(*recording.world, kSeed, name));
    }
    filter.selected = {};
    filter.hidden.clear();
    traversedRay_.reset();
    traversals_.clear();
    ++version_;
}

void DebugRays::clear() {
    recording_.reset();
    filter.selected = {};
    filter.hidden.clear();
    traversedRay_.reset();
    traversals_.clear();
    ++version_;
}

void DebugRays::selectSample(int index) {
    if (!recording_) return;
    sample_ = std::clamp(index, 0, std::max(0, recording_->samples - 1));
    record();
}

void DebugRays::showAllSamples(bool all) {
    filter.allSamples = all;
    if (recording_) record();
}

void DebugRays::updateReplay(const render::Film& film) {
    if (!recording_ || !recording_->verdict) return;
    const SampleId name = recording_->tree().name;
    int samples = 0;
    film.sums(name.x, name.y, samples);
    if (samples != recording_->verdict->samples)
        recording_->verdict = verifyReplay(*recording_->world, film, kSeed, name.x, name.y);
}

void DebugRays::select(RaySelection selection) {
    filter.selected = selection;
    ++version_;
}

const std::vector<probe::Diagnosis>& DebugRays::explain() {
    PixelRecording& recording = *recording_;
    const SampleId name = recording.tree().name;
    if (!recording.diagnosis)
        recording.diagnosis = probe::diagnosePixel(
            *recording.world, kSeed, name.x, name.y,
            std::min(probe::samplesToDiagnose(recording.state.settings), recording.samples));
    return *recording.diagnosis;
}

void DebugRays::show(const probe::Evidence& evidence) {
    selectSample(evidence.sample);
    select({evidence.node, evidence.shadow});
}

void DebugRays::pin() {
    if (!recording_) return;
    const RayTree& tree = recording_->tree();
    const RayNode& first = tree.nodes.front();
    double rays = 0.0;
    for (const std::uint32_t count : recording_->pixel.rays) rays += count;
    pins.push_back({{tree.name.x, tree.name.y},
                    first.hit ? probe::objectName(*recording_->world, first.object) : "nothing",
                    recording_->statistics.mean,
                    recording_->statistics.errorOfMean(),
                    rays / static_cast<double>(std::max<std::size_t>(recording_->pixel.rays.size(), 1))});
}

void DebugRays::hideSelected() {
    if (filter.selected.empty()) return;
    filter.hidden.push_back(filter.selected);
    filter.selected = {};
}

void DebugRays::updateTraversal() {
    const bool isKnown = traversedRay_ == filter.selected && traversedLayout_ == traversal.layout;
    if (!recording_ || !traversal.shown || isKnown) return;
    const RayTree& tree = recording_->tree();
    traversedRay_ = filter.selected;
    traversedLayout_ = traversal.layout;
    if (filter.selected.shadow >= 0) {
        const ShadowRay& shadow = tree.shadowRays[static_cast<std::size_t>(filter.selected.shadow)];
        traversals_ = probe::recordAnyHit(*recording_->world, shadow.ray, tree.time, traversal.layout);
    } else {
        const auto node = static_cast<std::size_t>(std::max(filter.selected.node, 0));
        traversals_ =
            probe::recordClosestHit(*recording_->world, tree.nodes[node].ray, tree.time, traversal.layout);
    }
    ++version_;
}

void DebugRays::step(int by) {
    traversal.shown = traversal.stepping = true;
    updateTraversal();
    std::size_t most = 0;
    for (const probe::TraversalLog& log : traversals_) most = std::max(most, log.steps.size());
    traversal.step = std::clamp(traversal.step + by, 0, static_cast<int>(most));
}

bool DebugRays::isStaleFor(const EditState& state, glm::ivec2 imageSize) const {
    return recording_ && (recording_->state.scene != state.scene ||
                          recording_->state.camera != state.camera || recording_->imageSize != imageSize ||
                          changed(recording_->state.settings, state.settings) > Invalidates::Display);
}

}  // namespace rayscope::viewer
