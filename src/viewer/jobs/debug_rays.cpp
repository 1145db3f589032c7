#include "viewer/jobs/debug_rays.h"

#include <rayscope/render_image.h>
#include <algorithm>
#include <utility>

#include "sampling/sample_stream.h"
#include "trace/world.h"
#include "viewer/model/viewer_seed.h"

namespace rayscope::viewer {

namespace {

std::size_t bytesOf(const RayTree& tree) {
    return sizeof tree + tree.nodes.size() * sizeof(RayNode) + tree.shadowRays.size() * sizeof(ShadowRay) +
           tree.addends.size() * sizeof(RgbSum);
}

/// Called before each of `samples` samples: reports the progress and throws Stopped on request.
class SampleCounter {
  public:
    SampleCounter(std::stop_token stop, JobProgress& progress, int samples)
        : stop_(std::move(stop)), progress_(&progress), samples_(std::max(samples, 1)) {}
    const std::stop_token& stop() const { return stop_; }
    void operator()() {
        if (stop_.stop_requested()) throw Stopped();
        progress_->store(static_cast<double>(done_++) / samples_);
    }

  private:
    std::stop_token stop_;
    JobProgress* progress_;
    int samples_, done_ = 0;
};

/// Samples 0 … `samples` - 1 of the pixel of `id`, until they take `budget` bytes.
std::vector<RayTree> recordTrees(const trace::World& world, SampleId id, int samples, std::size_t budget,
                                 SampleCounter beforeSample) {
    std::vector<RayTree> trees;
    std::size_t bytes = 0;
    for (id.index = 0; id.index < samples && bytes < budget; ++id.index) {
        beforeSample();
        trees.push_back(probeSample(world, kViewerSeed, id, beforeSample.stop()));
        bytes += bytesOf(trees.back());
    }
    return trees;
}

}  // namespace

void DebugRays::recordPixel(const TracedPicture& picture, int samples, SampleId id, Compare compare) {
    RenderRequest request = picture.request();
    // Beside the rasterised view the world is compiled for one sample per pixel.
    if (!sampling::dependsOnSampleCount(request.settings.sampler)) request.settings.spp = samples;
    following_.discard();
    startRecording(std::move(request), picture.world(), id,
                   compare == Compare::WithFilm ? picture.film() : nullptr);
}

void DebugRays::startRecording(RenderRequest request, std::shared_ptr<const trace::World> world, SampleId id,
                               std::shared_ptr<const render::Film> film) {
    PixelRecording recording;
    recording.request = std::move(request);
    recording.trees = {RayTree{}};
    recording.trees[0].name = id;
    recording.pixel = probe::replayPixel(*world, kViewerSeed, id.x, id.y, 1);
    recording.statistics = probe::statisticsOf(recording.pixel.values);
    recording.world = std::move(world);
    recording_ = std::move(recording);
    sample_ = id.index;
    verification_.discard();
    diagnosis_.discard();
    diagnosisRequested_ = pinRequested_ = false;
    recordSample();
    startReplay(id, std::move(film));
}

void DebugRays::startReplay(SampleId id, std::shared_ptr<const render::Film> film) {
    const int samples = std::min(recording_->samples(), maxSamples);
    replay_.start([world = recording_->world, film = std::move(film), id, samples](
                      const std::stop_token& stop, JobProgress& progress) {
        const int verified = film ? samplesOf(*film, id.x, id.y) : 0;
        SampleCounter counter(stop, progress, verified + samples);
        const auto beforeSample = [&counter] { counter(); };
        Replay replay;
        if (film)
            replay.replayResult = verifyReplay(*world, *film, kViewerSeed, id.x, id.y, beforeSample, stop);
        replay.pixel = probe::replayPixel(*world, kViewerSeed, id.x, id.y, samples, beforeSample, stop);
        replay.statistics = probe::statisticsOf(replay.pixel.values);
        return replay;
    });
}

void DebugRays::update() {
    if (auto replay = replay_.poll(); replay && recording_) {
        recording_->replayResult = std::move(replay->replayResult);
        recording_->pixel = std::move(replay->pixel);
        recording_->statistics = std::move(replay->statistics);
    }
    if (auto followed = following_.poll(); followed && recording_) recordFollowed(std::move(*followed));
    if (pinRequested_ && !replay_.busy()) pin();
    if (auto replayResult = verification_.poll(); replayResult && recording_)
        recording_->replayResult = std::move(*replayResult);
    if (auto diagnosis = diagnosis_.poll(); diagnosis && recording_)
        recording_->diagnosis = std::move(*diagnosis);
    auto trees = sampleTrees_.poll();
    if (!trees || !recording_ || !filter.allSamples) return;
    RayTree selected = recording_->tree();
    recording_->trees = std::move(*trees);
    recording_->chosen = static_cast<std::size_t>(sample_);
    if (recording_->chosen >= recording_->trees.size()) {
        recording_->chosen = recording_->trees.size();
        recording_->trees.push_back(std::move(selected));
    }
    ++version_;
}

/// Records the selected sample at once and, if they are shown, all others in the background.
void DebugRays::recordSample() {
    PixelRecording& recording = *recording_;
    SampleId id = recording.tree().name;
    id.index = sample_;
    recording.trees = {probeSample(*recording.world, kViewerSeed, id)};
    recording.chosen = 0;
    resetSelection();
    if (filter.allSamples)
        recordAllSamples();
    else
        sampleTrees_.discard();
}

void DebugRays::recordAllSamples() {
    sampleTrees_.start([world = recording_->world, id = recording_->tree().name,
                        samples = recording_->samples(),
                        budget = budget](const std::stop_token& stop, JobProgress& progress) {
        return recordTrees(*world, id, samples, budget, SampleCounter(stop, progress, samples));
    });
}

/// Ray indices belong to the selected sample.
void DebugRays::resetSelection() {
    clearSelection();
    filter.hidden.clear();
    tree_ = ++trees_;
}

void DebugRays::clearSelection() {
    filter.selected = {};
    traversedRay_.reset();
    traversals_.clear();
    ++version_;
}

void DebugRays::clear() { exchange(Shown{.whole = true}); }

DebugRays::Shown DebugRays::exchange(Shown shown) {
    Shown before{shown.whole, {}, std::move(filter.hidden), tree_};
    clearSelection();
    if (shown.whole) {
        replay_.discard();
        verification_.discard();
        sampleTrees_.discard();
        diagnosis_.discard();
        following_.discard();
        diagnosisRequested_ = pinRequested_ = false;
        before.recording = std::exchange(recording_, std::move(shown.recording));
        if (recording_) sample_ = recording_->tree().name.index;
        tree_ = recording_ ? shown.tree : ++trees_;
        // A replay that was discarded before its end starts again.
        if (recording_ && recording_->pixel.values.size() < static_cast<std::size_t>(recording_->samples()))
            startReplay(recording_->tree().name, nullptr);
    }
    filter.hidden.clear();
    if (shown.tree == tree_) filter.hidden = std::move(shown.hidden);
    return before;
}

DebugRays::Shown DebugRays::withoutSelected() const {
    Shown shown{false, {}, filter.hidden, tree_};
    shown.hidden.push_back(filter.selected);
    return shown;
}

void DebugRays::selectSample(int index) {
    if (!recording_) return;
    sample_ = std::clamp(index, 0, std::max(0, recording_->samples() - 1));
    const auto number = static_cast<std::size_t>(sample_);
    const bool isRecorded = filter.allSamples && number < recording_->trees.size() &&
                            recording_->trees[number].name.index == sample_;
    if (!isRecorded) return recordSample();
    recording_->chosen = number;
    resetSelection();
}

void DebugRays::showAllSamples(bool all) {
    filter.allSamples = all;
    if (recording_) recordSample();
}

void DebugRays::verify(const TracedPicture& picture) {
    if (!recording_ || replay_.busy() || verification_.busy()) return;
    if (!isSameFrame(recording_->request, picture.request())) return;
    const SampleId id = recording_->tree().name;
    const int samples = samplesOf(*picture.film(), id.x, id.y);
    if (recording_->replayResult && samples == recording_->replayResult->samples) return;
    verification_.start([world = recording_->world, film = picture.film(), id, samples](
                            const std::stop_token& stop, JobProgress& progress) {
        return verifyReplay(*world, *film, kViewerSeed, id.x, id.y, SampleCounter(stop, progress, samples),
                            stop);
    });
}

void DebugRays::select(RaySelection selection) {
    filter.selected = selection;
    ++version_;
}

const std::vector<probe::Diagnosis>* DebugRays::diagnose() {
    PixelRecording& recording = *recording_;
    if (!recording.diagnosis && !std::exchange(diagnosisRequested_, true)) {
        const SampleId id = recording.tree().name;
        const int samples =
            std::min(probe::samplesToDiagnose(recording.request.settings), recording.samples());
        diagnosis_.start(
            [world = recording.world, id, samples](const std::stop_token& stop, JobProgress& progress) {
                return probe::diagnosePixel(*world, kViewerSeed, id.x, id.y, samples,
                                            SampleCounter(stop, progress, samples), stop);
            });
    }
    return recording.diagnosis ? &*recording.diagnosis : nullptr;
}

void DebugRays::show(const probe::Evidence& evidence) {
    selectSample(evidence.sample);
    select({evidence.node, evidence.shadow});
}

void DebugRays::pin() {
    pinRequested_ = recording_ && replay_.busy();
    if (!recording_ || pinRequested_) return;
    const RayTree& tree = recording_->tree();
    const RayNode& first = tree.nodes.front();
    double rays = 0.0;
    for (const std::uint32_t count : recording_->pixel.rays) rays += count;
    pins.push_back({{tree.name.x, tree.name.y},
                    first.hit ? objectName(*recording_->world, first.object) : "nothing",
                    recording_->statistics.mean,
                    recording_->statistics.errorOfMean(),
                    rays / static_cast<double>(std::max<std::size_t>(recording_->pixel.rays.size(), 1)),
                    first.hit ? std::optional(first.position) : std::nullopt});
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

bool DebugRays::isOf(const EditState& state, glm::ivec2 imageSize) const {
    return recording_ && isSameFrame(recording_->request, requestOf(state, imageSize.x, imageSize.y));
}

}  // namespace rayscope::viewer
