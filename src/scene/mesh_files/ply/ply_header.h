#pragma once
// The header of PLY files (Turk 1994, "The PLY Polygon File Format").
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/block_reader.h"
#include "scene/oddities.h"

namespace rayscope::scene {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
constexpr bool isInteger(PlyType type) { return type < PlyType::Float32; }

/// Calls `visit` with a value of the C++ type that stores `type`.
template <class Visit>
auto visitType(PlyType type, const Visit& visit) {
    switch (type) {
        case PlyType::Int8:
            return visit(std::int8_t{});
        case PlyType::UInt8:
            return visit(std::uint8_t{});
        case PlyType::Int16:
            return visit(std::int16_t{});
        case PlyType::UInt16:
            return visit(std::uint16_t{});
        case PlyType::Int32:
            return visit(std::int32_t{});
        case PlyType::UInt32:
            return visit(std::uint32_t{});
        case PlyType::Float32:
            return visit(float{});
        case PlyType::Float64:
            break;
    }
    return visit(double{});
}
inline std::size_t sizeOf(PlyType type) {
    return visitType(type, [](auto value) { return sizeof value; });
}

/// A number per row of an element or, with a count type, a list of numbers.
struct PlyProperty {
    std::string name;  ///< in lower case
    PlyType type;      ///< of the number, or of those in the list
    std::optional<PlyType> countType;
    int line;
};

struct PlyElement {
    std::string name;  ///< in lower case
    std::uint64_t count;
    std::vector<PlyProperty> properties;
    int line;

    /// The size of a row in a binary file if its lists are empty.
    std::size_t smallestRow() const;
    bool hasLists() const;
};

struct PlyHeader {
    PlyFormat format;
    std::vector<PlyElement> elements;
    std::vector<std::string> textureFiles;  ///< of comments "TextureFile NAME", as MeshLab writes them
    int lines;

    /// The index of an element, or the number of elements.
    std::size_t find(std::string_view name) const;
};

/// Reads the header and leaves `input` at the byte behind it. Throws InputError with the line.
PlyHeader readPlyHeader(const std::string& path, base::BlockReader& input, Oddities& oddities);

}  // namespace rayscope::scene
