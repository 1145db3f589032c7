// Replaces embree_baseline.cpp where Embree is not installed.
#include <stdexcept>

#include "measure/bench/embree_baseline.h"

namespace rayscope::measure {

struct EmbreeBaseline::State {};

bool EmbreeBaseline::isAvailable() { return false; }
EmbreeBaseline::EmbreeBaseline(const AccelInput&, bool, int) {
    throw std::runtime_error("Embree is not available");
}
EmbreeBaseline::~EmbreeBaseline() = default;
double EmbreeBaseline::buildSeconds() const { return 0.0; }
std::size_t EmbreeBaseline::bytes() const { return 0; }
void EmbreeBaseline::closestHits(EmbreeQuery, bool, std::span<const Ray>, std::span<Hit>) const {}
void EmbreeBaseline::anyHits(EmbreeQuery, bool, std::span<const Ray>, std::span<std::uint8_t>) const {}

}  // namespace rayscope::measure
