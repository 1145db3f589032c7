#pragma once
// What can be watched while a sample is computed. The tracer is a template over its observer: with the silent
// one nothing of it remains, and every watcher sees the very same computation.
#include <rayscope/path.h>

#include "trace/interaction.h"

namespace rayscope::trace {

/// A ray that sets out, and what its radiance will be multiplied with.
struct Segment {
    Ray ray;
    RayKind kind = RayKind::Camera;
    int depth = 0;  ///< reflections before it
    glm::dvec3 throughput{1.0};
    RayCone cone;
};

/// A position on a light as seen from a surface, and the verdict on it.
struct LightConnection {
    int light = 0, sample = 0;
    glm::vec3 from{0.0f};
    shading::LightSample at;
    Visibility visibility = Visibility::Visible;
};

/// A hook receives only values that the tracer has anyway. Segments come in depth-first order: a Reflection
/// or Glossy segment of depth d starts at the surface that the latest segment of depth d − 1 met, a
/// Transparent one at the surface that the latest segment of its own depth met.
template <class O>
concept PathObserver = requires(O& o, const Segment& segment, const Interaction& at,
                                const LightConnection& light, const glm::dvec3& value, RayEnd why) {
    o.segment(segment);  ///< a ray sets out …
    o.hit(at);           ///< … and meets a surface,
    o.lightSampled(light,
                   value);  ///< a light was sampled from there, adding `value` to the radiance of the sample
    o.added(value);         ///< a term was added to the radiance of the sample; all of them sum up to it
    o.ended(segment, why);  ///< what became of the path after that segment
};

struct NullObserver {
    static void segment(const Segment&) {}
    static void hit(const Interaction&) {}
    static void lightSampled(const LightConnection&, const glm::dvec3&) {}
    static void added(const glm::dvec3&) {}
    static void ended(const Segment&, RayEnd) {}
};
static_assert(PathObserver<NullObserver>);

}  // namespace rayscope::trace
