#include "measure/bench/picture_rays.h"

#include <algorithm>

#include "trace/radiance_batch.h"
#include "trace/radiance_definition.h"

namespace rayscope::measure {
namespace {

/// An observer that appends the rays of a sample to lists.
class RayRecorder {
  public:
    RayRecorder(const trace::World& world, PictureRays& rays, TimedRays& others)
        : world_(world), rays_(rays), others_(others) {}

    /// Before a sample. The ray that decides whether it is in the sharp zone is not a segment of its path.
    void begin(const trace::CameraSample& sample) {
        time_ = sample.time;
        if (world_.settings.sharpZone > 0.0f && !trace::hasSingleCameraRays(world_))
            append(rays_.closest, world_.camera.pinholeRay(sample.pixel));
    }

    void segment(const trace::Segment& segment) {
        latest_ = segment.kind == RayKind::Camera ? &rays_.closest : &others_;
        append(*latest_, segment.ray);
    }
    static void hit(const trace::Interaction&) {}
    void lightSampled(const trace::LightConnection& light, const glm::dvec3&) {
        if (light.visibility == Visibility::FacingAway ||
            !world_.lights[static_cast<std::size_t>(light.light)].castsShadows)
            return;
        const Ray shadow = trace::shadowRay(light.from, light.at.position);
        if (!world_.attenuatesShadows) return append(rays_.any, shadow);
        trace::transmittanceAlong(world_, shadow, time_, {},
                                  [this](const Ray& ray) { append(others_, ray); });
    }
    static void added(const glm::dvec3&) {}
    void ended(const trace::Segment&, RayEnd end) {
        // It is not traced.
        if (end == RayEnd::BelowSurface) dropLast(*latest_);
    }

  private:
    void append(TimedRays& list, const Ray& ray) {
        list.rays.push_back(ray);
        if (world_.moves) list.times.push_back(time_);
    }
    void dropLast(TimedRays& list) const {
        list.rays.pop_back();
        if (world_.moves) list.times.pop_back();
    }

    const trace::World& world_;
    PictureRays& rays_;
    TimedRays& others_;
    TimedRays* latest_ = nullptr;
    float time_ = 0.0f;
};

void moveTo(TimedRays& list, TimedRays& added) {
    list.rays.insert(list.rays.end(), added.rays.begin(), added.rays.end());
    list.times.insert(list.times.end(), added.times.begin(), added.times.end());
    added.rays.clear();
    added.times.clear();
}

}  // namespace

PictureRays recordRays(const trace::World& world, std::uint64_t seed, std::span<const SampleId> samples) {
    const Settings& settings = world.settings;
    PictureRays rays;
    TimedRays others;
    RayRecorder recorder(world, rays, others);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SampleId& sample = samples[i];
        const sampling::SampleStream stream(settings.sampler, seed, sample.x, sample.y, sample.index,
                                            settings.spp);
        recorder.begin(trace::CameraSample(world, stream, sample));
        trace::radiance(world, seed, sample, recorder);
        if ((i + 1) % trace::RadianceBatch::kSize == 0) moveTo(rays.closest, others);
    }
    moveTo(rays.closest, others);
    return rays;
}

}  // namespace rayscope::measure
