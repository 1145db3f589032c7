#include "bvh/layout/primitive_refs.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

using Block = tbb::blocked_range<std::size_t>;

/// Node numbers have 32 bits. n primitives may need 2n − 1 nodes, and threads leave some unused.
constexpr std::size_t kMaxPrimitives = (std::size_t{1} << 31) - (std::size_t{1} << 20);

/// The number of the first triangle with an invalid vertex index, or the number of triangles.
std::size_t firstBadTriangle(const AccelInput& input, const std::stop_token& stop) {
    const std::size_t count = input.triangles.size();
    return tbb::parallel_reduce(
        Block(0, count, kTaskSize), count,
        [&](const Block& block, std::size_t found) {
            throwIfStopped(stop);
            for (std::size_t i = block.begin(); i < std::min(block.end(), found); ++i) {
                const glm::uvec3& corner = input.triangles[i];
                if (std::max({corner.x, corner.y, corner.z}) >= input.vertices.size()) return i;
            }
            return found;
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

}  // namespace

void checkPrimitiveCount(const AccelInput& input) {
    const std::size_t count = input.triangles.size() + input.spheres.size();
    if (count > kMaxPrimitives)
        throw std::length_error(fmt::format(
            "{} primitives exceed the limit of {} of one BVH; split the scene", count, kMaxPrimitives));
}

void checkIndices(const AccelInput& input, const std::stop_token& stop) {
    const std::size_t bad = firstBadTriangle(input, stop);
    if (bad == input.triangles.size()) return;
    const glm::uvec3& corner = input.triangles[bad];
    throw std::invalid_argument(fmt::format("triangle {} has vertex index {}, but there are {} vertices", bad,
                                            std::max({corner.x, corner.y, corner.z}), input.vertices.size()));
}

PrimitiveBox boxOfPrimitive(const AccelInput& input, std::size_t primitive) {
    if (primitive >= input.triangles.size()) return boxOf(input.spheres[primitive - input.triangles.size()]);
    const glm::uvec3& corner = input.triangles[primitive];
    return boxOf(input.vertices[corner.x], input.vertices[corner.y], input.vertices[corner.z]);
}

bool hasFiniteCoordinates(const AccelInput& input, std::size_t primitive) {
    const auto finite = [](float x) { return std::isfinite(x); };
    if (primitive >= input.triangles.size()) {
        const PrimitiveBox box = boxOfPrimitive(input, primitive);
        return std::all_of(box.planes, box.planes + 8, finite);
    }
    // The box may be finite although a coordinate is NaN, because min() and max() may drop a NaN.
    const glm::uvec3& corner = input.triangles[primitive];
    for (int k = 0; k < 3; ++k) {
        const glm::vec3& v = input.vertices[corner[k]];
        if (!finite(v.x) || !finite(v.y) || !finite(v.z)) return false;
    }
    return true;
}

std::size_t countNonFinitePrimitives(const AccelInput& input, const std::stop_token& stop) {
    return tbb::parallel_reduce(
        Block(0, input.triangles.size() + input.spheres.size(), kTaskSize), std::size_t{0},
        [&](const Block& block, std::size_t sum) {
            throwIfStopped(stop);
            for (std::size_t i = block.begin(); i < block.end(); ++i) sum += !hasFiniteCoordinates(input, i);
            return sum;
        },
        std::plus<>{});
}

namespace {

PrimitiveRef makeRef(const AccelInput& input, std::size_t primitive) {
    const PrimitiveBox box = boxOfPrimitive(input, primitive);
    PrimitiveRef ref{};
    std::copy_n(box.planes, 3, ref.lower);
    std::copy_n(box.planes + 4, 3, ref.upper);
    ref.primitive =
        hasFiniteCoordinates(input, primitive) ? static_cast<std::uint32_t>(primitive) : kNoPrimitive;
    return ref;
}

}  // namespace

PrimitiveRefs collectPrimitiveRefs(const AccelInput& input, const std::stop_token& stop) {
    checkPrimitiveCount(input);
    checkIndices(input, stop);
    PrimitiveRefs result;
    const std::size_t count = input.triangles.size() + input.spheres.size();
    result.refs.resize(count);
    const std::size_t dropped = tbb::parallel_reduce(
        Block(0, count, kTaskSize), std::size_t{0},
        [&](const Block& block, std::size_t sum) {
            throwIfStopped(stop);
            for (std::size_t i = block.begin(); i < block.end(); ++i) {
                result.refs[i] = makeRef(input, i);
                sum += result.refs[i].primitive == kNoPrimitive;
            }
            return sum;
        },
        std::plus<>{});
    if (dropped > 0)
        std::erase_if(result.refs, [](const PrimitiveRef& ref) { return ref.primitive == kNoPrimitive; });
    result.dropped = static_cast<std::uint32_t>(dropped);
    return result;
}

}  // namespace rayscope::bvh
