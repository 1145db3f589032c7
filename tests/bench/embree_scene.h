#pragma once
#include <embree3/rtcore.h>

#include "bench/bench_scene.h"

namespace rayscope::bench {

/// The same mesh in Embree, medium quality, queried ray by ray.
class EmbreeScene {
  public:
    EmbreeScene(const BumpySphere& mesh, bool robust);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    void trace(const std::vector<Ray>& rays, bool any) const;

  private:
    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace rayscope::bench
