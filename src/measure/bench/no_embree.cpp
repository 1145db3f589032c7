// Stands in for embree_race.cpp where Embree is not installed.
#include <stdexcept>

#include "measure/bench/embree_race.h"

namespace rayscope::measure {

struct EmbreeRace::State {};

bool EmbreeRace::isAvailable() { return false; }
EmbreeRace::EmbreeRace(const AccelInput&, bool, int) { throw std::runtime_error("Embree is not available"); }
EmbreeRace::~EmbreeRace() = default;
double EmbreeRace::buildSeconds() const { return 0.0; }
std::size_t EmbreeRace::bytes() const { return 0; }
void EmbreeRace::closestHits(EmbreeQuery, bool, std::span<const Ray>, std::span<Hit>) const {}
void EmbreeRace::anyHits(EmbreeQuery, bool, std::span<const Ray>, std::span<std::uint8_t>) const {}

}  // namespace rayscope::measure
