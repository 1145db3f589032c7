#include "bvh/builders/sort_centroids.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

struct KeyedIndex {
    std::uint32_t key, index;
    bool operator<(const KeyedIndex& other) const {
        return key < other.key || (key == other.key && index < other.index);
    }
};

/// Unsigned integers in the order of the floats; both zeros are equal.
std::uint32_t keyOf(float x) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x + 0.0f);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

constexpr std::size_t kSmall = 1024;  ///< up to here std::sort is faster
constexpr int kDigitBits = 11;

/// One stable pass of a least-significant-digit radix sort.
void sortByDigit(const KeyedIndex* from, KeyedIndex* to, std::size_t size, int shift,
                 const std::stop_token& stop) {
    constexpr std::uint32_t kMask = (1u << kDigitBits) - 1;
    std::array<std::size_t, kMask + 1> offsets{};
    for (std::size_t i = 0; i < size; ++i) ++offsets[(from[i].key >> shift) & kMask];
    std::size_t sum = 0;
    for (std::size_t& offset : offsets) sum += std::exchange(offset, sum);
    for (std::size_t i = 0; i < size; ++i) {
        if (i % kStopInterval == 0) throwIfStopped(stop);
        to[offsets[(from[i].key >> shift) & kMask]++] = from[i];
    }
}

}  // namespace

base::BigVector<std::uint32_t> orderByCentroid(std::span<const PrimitiveRef> refs, int axis,
                                               const std::stop_token& stop) {
    const std::size_t size = refs.size();
    base::BigVector<KeyedIndex> pairs(size);
    for (std::size_t i = 0; i < size; ++i) {
        if (i % kStopInterval == 0) throwIfStopped(stop);
        pairs[i] = {keyOf(refs[i].centroid(axis)), static_cast<std::uint32_t>(i)};
    }
    if (size <= kSmall) {
        std::sort(pairs.begin(), pairs.end());
    } else {
        base::BigVector<KeyedIndex> scratch(size);
        for (int shift = 0; shift < 32; shift += kDigitBits) {
            sortByDigit(pairs.data(), scratch.data(), size, shift, stop);
            pairs.swap(scratch);
        }
    }
    base::BigVector<std::uint32_t> order;
    order.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        if (i % kStopInterval == 0) throwIfStopped(stop);
        order.push_back(pairs[i].index);
    }
    return order;
}

}  // namespace rayscope::bvh
