#include "scene/mesh_files/gltf/accessor_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace rayscope::scene {

namespace {

template <class Action>
void withComponentType(GltfComponent component, Action&& action) {
    switch (component) {
        case GltfComponent::Byte:
            return action(std::int8_t{});
        case GltfComponent::UnsignedByte:
            return action(std::uint8_t{});
        case GltfComponent::Short:
            return action(std::int16_t{});
        case GltfComponent::UnsignedShort:
            return action(std::uint16_t{});
        case GltfComponent::UnsignedInt:
            return action(std::uint32_t{});
        case GltfComponent::Float:
            return action(float{});
    }
}

std::size_t sizeOf(GltfComponent component) {
    std::size_t size = 0;
    withComponentType(component, [&](auto zero) { size = sizeof zero; });
    return size;
}

/// Normalized integers as the format defines them: −128 and −127 both become −1.
template <class Value, class Stored>
Value converted(Stored stored, bool normalized) {
    if constexpr (std::is_integral_v<Stored> && std::is_floating_point_v<Value>) {
        if (normalized)
            return std::max(
                static_cast<Value>(stored) / static_cast<Value>(std::numeric_limits<Stored>::max()),
                Value{-1});
    }
    return static_cast<Value>(stored);
}

}  // namespace

void GltfAccessorReader::fail(std::uint32_t index, const std::string& message) const {
    throw InputError(fmt::format("accessors[{}]: {}", index, message), {path_});
}

GltfAccessorReader::Elements GltfAccessorReader::elements(std::uint32_t index, std::uint32_t view,
                                                          std::uint64_t offset, std::uint64_t count,
                                                          std::size_t elementSize, bool strided) {
    const GltfBytes bytes = resources_.view(view);
    const std::uint64_t stated = strided ? document_.views[view].byteStride : 0;
    const std::uint64_t stride = stated == 0 ? elementSize : stated;
    if (stride < elementSize)
        fail(index, fmt::format("elements of {} bytes exceed the byteStride {}", elementSize, stride));
    // Divides instead of multiplying, which could overflow.
    const bool fits = count == 0 || (offset <= bytes.size() && elementSize <= bytes.size() - offset &&
                                     (bytes.size() - offset - elementSize) / stride >= count - 1);
    if (!fits)
        fail(index, fmt::format("{} elements of {} bytes at {} exceed the {} bytes of bufferViews[{}]", count,
                                stride, offset, bytes.size(), view));
    return {bytes.data() + (count == 0 ? 0 : offset), static_cast<std::size_t>(stride),
            static_cast<std::size_t>(count)};
}

template <class Value>
std::vector<Value> GltfAccessorReader::read(std::uint32_t index) {
    const GltfAccessor& a = document_.accessors[index];
    const std::size_t elementSize = sizeOf(a.component) * a.components;
    std::vector<Value> values;
    if (a.view) {
        const Elements from = elements(index, *a.view, a.byteOffset, a.count, elementSize, true);
        values.resize(from.count * a.components);
        withComponentType(a.component, [&](auto stored) {
            Value* to = values.data();
            for (std::size_t i = 0; i < from.count; ++i)
                for (std::uint32_t c = 0; c < a.components; ++c) {
                    std::memcpy(&stored, from.data + i * from.stride + c * sizeof stored, sizeof stored);
                    *to++ = converted<Value>(stored, a.normalized);
                }
        });
    } else {
        // Zeros cost no bytes in the file; a few bytes must not claim gigabytes.
        constexpr std::uint64_t kFree = 1 << 20;
        if (a.count > std::max(kFree, resources_.totalBytes()))
            fail(index,
                 fmt::format("{} elements without a bufferView; the file is too small for that", a.count));
        values.resize(static_cast<std::size_t>(a.count) * a.components);
    }
    if (a.sparse) readSparse(index, values);
    return values;
}

template <class Value>
void GltfAccessorReader::readSparse(std::uint32_t index, std::vector<Value>& values) {
    const GltfAccessor& a = document_.accessors[index];
    const GltfSparse& sparse = *a.sparse;
    const Elements places = elements(index, sparse.indicesView, sparse.indicesOffset, sparse.count,
                                     sizeOf(sparse.indexType), false);
    const Elements from = elements(index, sparse.valuesView, sparse.valuesOffset, sparse.count,
                                   sizeOf(a.component) * a.components, false);
    std::vector<std::uint64_t> targets;
    targets.reserve(places.count);
    withComponentType(sparse.indexType, [&](auto stored) {
        for (std::size_t i = 0; i < places.count; ++i) {
            std::memcpy(&stored, places.data + i * places.stride, sizeof stored);
            if (!(static_cast<double>(stored) >= 0.0 &&
                  static_cast<double>(stored) < static_cast<double>(a.count)))
                fail(index, fmt::format("sparse index {} is out of range: {} elements", stored, a.count));
            targets.push_back(static_cast<std::uint64_t>(stored));
        }
    });
    withComponentType(a.component, [&](auto stored) {
        for (std::size_t i = 0; i < from.count; ++i)
            for (std::uint32_t c = 0; c < a.components; ++c) {
                std::memcpy(&stored, from.data + i * from.stride + c * sizeof stored, sizeof stored);
                values[static_cast<std::size_t>(targets[i]) * a.components + c] =
                    converted<Value>(stored, a.normalized);
            }
    });
}

std::vector<float> GltfAccessorReader::floats(std::uint32_t index, std::uint32_t components) {
    if (accessor(index).components != components)
        fail(index, fmt::format("{} components per element where {} are expected", accessor(index).components,
                                components));
    return read<float>(index);
}

std::vector<std::uint32_t> GltfAccessorReader::indices(std::uint32_t index) {
    const GltfAccessor& a = accessor(index);
    const bool isUnsigned = a.component == GltfComponent::UnsignedByte ||
                            a.component == GltfComponent::UnsignedShort ||
                            a.component == GltfComponent::UnsignedInt;
    if (a.components != 1 || !isUnsigned) fail(index, "indices must be scalars of an unsigned integer type");
    return read<std::uint32_t>(index);
}

}  // namespace rayscope::scene
