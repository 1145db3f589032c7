#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rayscope::scene {

/// A corner of a face: zero-based indices of position, texture coordinate and normal; −1: not given.
struct Corner {
    std::int32_t position = -1, texCoord = -1, normal = -1;
    bool operator==(const Corner&) const = default;
};

/// Numbers distinct corners in the order of their first occurrence. Open addressing: 20 to 28 bytes per
/// distinct corner.
class CornerTable {
  public:
    std::uint32_t indexOf(const Corner& corner) {
        if (corners_.size() * 2 >= slots_.size()) grow();
        std::uint32_t& slot = slotOf(corner);
        if (slot == kEmpty) {
            slot = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(corner);
        }
        return slot;
    }
    const std::vector<Corner>& corners() const { return corners_; }

  private:
    static constexpr std::uint32_t kEmpty = 0xffffffffu;

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
        slots_.assign(slots_.empty() ? 1024 : slots_.size() * 2, kEmpty);
        for (std::size_t i = 0; i < corners_.size(); ++i) slotOf(corners_[i]) = static_cast<std::uint32_t>(i);
    }

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace rayscope::scene
