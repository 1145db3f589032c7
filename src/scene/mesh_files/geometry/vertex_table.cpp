#include "scene/mesh_files/geometry/vertex_table.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace rayscope::scene {

namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;

std::size_t hashOf(const glm::vec3& p) {
    std::uint64_t h = std::bit_cast<std::uint32_t>(p.x) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.y)) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.z)) * 0x94d049bb133111ebull;
    return static_cast<std::size_t>(h ^ (h >> 32));
}

void prefetch(const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#else
    static_cast<void>(address);
#endif
}

}  // namespace

VertexTable::VertexTable(std::size_t expected) {
    points_.reserve(expected);
    slots_.assign(std::bit_ceil(std::max<std::size_t>(2 * expected, 2 * kMostAtOnce)), kEmpty);
}

void VertexTable::indicesOf(std::span<const glm::vec3> points, std::uint32_t* indices) {
    if ((points_.size() + points.size()) * 2 > slots_.size()) grow();
    // The lookups of many points are interleaved, because each is a cache miss or two.
    std::array<std::size_t, kMostAtOnce> hashes;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        hashes[i] = hashOf(points[i]) & mask;
        prefetch(&slots_[hashes[i]]);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const std::uint32_t known = slots_[hashes[i]]; known != kEmpty) prefetch(&points_[known]);
    for (std::size_t i = 0; i < points.size(); ++i) indices[i] = indexOf(points[i], hashes[i]);
}

std::uint32_t VertexTable::indexOf(const glm::vec3& point, std::size_t slot) {
    const std::size_t mask = slots_.size() - 1;
    for (;; slot = (slot + 1) & mask) {
        const std::uint32_t known = slots_[slot];
        if (known == kEmpty) break;
        if (std::memcmp(&points_[known], &point, sizeof point) == 0) return known;
    }
    if (points_.size() >= kEmpty) throw std::length_error("more than 4294967295 vertices");
    slots_[slot] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    return slots_[slot];
}

void VertexTable::grow() {
    slots_.assign(slots_.size() * 2, kEmpty);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        std::size_t slot = hashOf(points_[i]) & mask;
        while (slots_[slot] != kEmpty) slot = (slot + 1) & mask;
        slots_[slot] = static_cast<std::uint32_t>(i);
    }
}

}  // namespace rayscope::scene
