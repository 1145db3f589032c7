#pragma once
// Boxes of the builders, in vectors of four floats of which the fourth has no meaning.
#include <cstdint>
#include <cstring>
#include <limits>

namespace rayscope::bvh {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 minimum(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 maximum(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 broadcast(float x) { return Float4{x, x, x, x}; }
inline Int4 broadcast(std::int32_t x) { return Int4{x, x, x, x}; }

/// Half the surface area of a box with these edge lengths: a vector of float or double.
template <class Size>
auto halfAreaOf(const Size& size) {
    return size[0] * (size[1] + size[2]) + size[1] * size[2];
}

struct Bounds4 {
    Float4 lower = broadcast(std::numeric_limits<float>::infinity());
    Float4 upper = broadcast(-std::numeric_limits<float>::infinity());

    /// Ignores NaN.
    void extend(Float4 point) {
        lower = minimum(point, lower);
        upper = maximum(point, upper);
    }
    void extend(const Bounds4& box) {
        lower = minimum(lower, box.lower);
        upper = maximum(upper, box.upper);
    }
    /// Of a box that is not empty, in units of 1 / scale².
    float halfArea(float scale) const { return halfAreaOf((upper - lower) * broadcast(scale)); }
};

/// The bounding box of a primitive, while the tree is built.
struct PrimitiveRef {
    float lower[3];
    std::uint32_t primitive;
    float upper[3];
    std::uint32_t unused;

    Bounds4 bounds() const {
        Bounds4 box;
        std::memcpy(&box.lower, lower, sizeof box.lower);
        std::memcpy(&box.upper, upper, sizeof box.upper);
        // The primitive number as a float is denormal, which makes arithmetic a hundred times slower.
        box.lower = reinterpret_cast<Float4>(reinterpret_cast<Int4>(box.lower) & Int4{-1, -1, -1, 0});
        return box;
    }
    /// Halved before adding, so that large coordinates do not overflow.
    Float4 centroid() const {
        const Bounds4 box = bounds();
        return box.lower * broadcast(0.5f) + box.upper * broadcast(0.5f);
    }
    float centroid(int axis) const { return lower[axis] * 0.5f + upper[axis] * 0.5f; }
};
static_assert(sizeof(PrimitiveRef) == 32);

}  // namespace rayscope::bvh
