#pragma once
// The events of a path. The tracer is a template over its observer: hooks of the NullObserver compile to
// nothing, and the radiance is the same, bit for bit, for every observer.
#include <rayscope/path.h>

#include "trace/interaction.h"

namespace rayscope::trace {

/// One ray of a path.
struct Segment {
    Ray ray;
    RayKind kind = RayKind::Camera;
    int depth = 0;               ///< number of reflections before it
    glm::dvec3 throughput{1.0};  ///< factor of its radiance in the radiance of the sample
    RayCone cone;
};

/// The segment from a surface to a light sample.
struct LightConnection {
    int light = 0, sample = 0;
    glm::vec3 from{0.0f};  ///< origin of the shadow ray
    shading::LightSample at;
    Visibility visibility = Visibility::Visible;
};

/// The hooks of an observer; they receive values that the tracer computes in any case. Segments come in
/// depth-first order: a Reflection or Glossy segment of depth d starts at the latest hit of depth d − 1, a
/// Transparent one at the latest hit of its own depth.
template <class O>
concept PathObserver = requires(O& o, const Segment& segment, const Interaction& at,
                                const LightConnection& light, const glm::dvec3& value, RayEnd end) {
    /// Before the ray of a segment is traced.
    o.segment(segment);
    /// The segment hit a surface.
    o.hit(at);
    /// A light was sampled from the latest hit; `value` is the sample's term, zero if it is occluded.
    o.lightSampled(light, value);
    /// A term was added to the radiance of the sample. The radiance is the left fold of all terms.
    o.added(value);
    /// The segment is finished; `end` is the reason why the path continues or ends.
    o.ended(segment, end);
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
