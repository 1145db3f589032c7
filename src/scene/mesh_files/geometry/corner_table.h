#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace rayscope::scene {

/// A corner of a face: zero-based indices of position, texture coordinate and normal; −1: not given.
struct Corner {
    std::int32_t position = -1, texCoord = -1, normal = -1;
    bool operator==(const Corner&) const = default;
};

/// Numbers distinct corners in the order of their first occurrence. The first corner at a position is found
/// by its position, the others by a hash table with open addressing: 16 to 32 bytes per distinct corner.
class CornerTable {
  public:
    /// `maxPositions`: upper bound of the number of positions, if indices are not checked yet; corners beyond
    /// have no place by position.
    explicit CornerTable(std::size_t maxPositions = std::numeric_limits<std::size_t>::max())
        : maxPositions_(maxPositions) {}

    std::uint32_t indexOf(const Corner& corner) {
        const auto position = static_cast<std::size_t>(corner.position);
        if (position >= firstAt_.size()) {
            if (position >= maxPositions_) return hashedIndexOf(corner);
            firstAt_.resize(std::min(std::max(position + 1, 2 * firstAt_.size()), maxPositions_), kEmpty);
        }
        std::uint32_t& first = firstAt_[position];
        if (first == kEmpty) return first = append(corner);
        return corners_[first] == corner ? first : hashedIndexOf(corner);
    }
    const std::vector<Corner>& corners() const { return corners_; }
    /// The distinct corners; the table is empty afterwards.
    std::vector<Corner> takeCorners() {
        firstAt_.clear();
        slots_.clear();
        return std::move(corners_);
    }

  private:
    static constexpr std::uint32_t kEmpty = 0xffffffffu;

    std::uint32_t append(const Corner& corner) {
        corners_.push_back(corner);
        return static_cast<std::uint32_t>(corners_.size() - 1);
    }
    std::uint32_t hashedIndexOf(const Corner& corner) {
        if (hashed_ * 2 >= slots_.size()) grow();
        std::uint32_t& slot = slotOf(corner);
        if (slot == kEmpty) {
            slot = append(corner);
            ++hashed_;
        }
        return slot;
    }
    static std::size_t hash(const Corner& c) {
        std::uint64_t h = static_cast<std::uint32_t>(c.position) * 0x9e3779b97f4a7c15ull;
        h = (h ^ (h >> 32) ^ static_cast<std::uint32_t>(c.texCoord)) * 0xbf58476d1ce4e5b9ull;
        h = (h ^ (h >> 32) ^ static_cast<std::uint32_t>(c.normal)) * 0x94d049bb133111ebull;
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
    std::uint32_t& slotOf(const Corner& corner) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash(corner) & mask;
        while (slots_[i] != kEmpty && !(corners_[slots_[i]] == corner)) i = (i + 1) & mask;
        return slots_[i];
    }
    void grow() {
        std::vector<std::uint32_t> old(slots_.empty() ? 1024 : slots_.size() * 2, kEmpty);
        old.swap(slots_);
        for (const std::uint32_t index : old)
            if (index != kEmpty) slotOf(corners_[index]) = index;
    }

    std::size_t maxPositions_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> firstAt_;  ///< per position: its first corner
    std::vector<std::uint32_t> slots_;    ///< of the other corners
    std::size_t hashed_ = 0;
};

}  // namespace rayscope::scene
