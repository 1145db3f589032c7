#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scene/mesh_files/ply/ply_rows.h"

namespace rayscope::scene {

namespace {

template <class T>
T loadAs(const char* from, bool swaps) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, from, sizeof(T));
    if (swaps) std::reverse(bytes, bytes + sizeof(T));
    return std::bit_cast<T>(bytes);
}

template <class To, class From>
To convertTo(From value) {
    if constexpr (std::is_integral_v<To> && std::is_floating_point_v<From>) {
        constexpr From kLimit = 9007199254740992.0;  // 2^53
        return std::abs(value) < kLimit && value == std::floor(value) ? static_cast<To>(value) : kNoInteger;
    } else {
        return static_cast<To>(value);
    }
}

class BinaryReader {
  public:
    explicit BinaryReader(const PlyRows& rows)
        : rows_(rows),
          input_(rows.input),
          plan_(rows.plan),
          swaps_((plan_.header.format == PlyFormat::BigEndian) != (std::endian::native == std::endian::big)) {
    }

    void read() {
        const std::vector<PlyElement>& elements = plan_.header.elements;
        for (element_ = 0; element_ < elements.size(); ++element_) {
            row_ = 0;
            if (element_ == plan_.vertices)
                readVertices();
            else if (element_ == plan_.faces)
                readFaces();
            else if (element_ == plan_.strips)
                readStrips();
            else
                skipElement();
        }
        if (input_.size() && input_.remaining() > 0)
            rows_.oddities.add(Severity::Warning, fmt::format("{} bytes behind the last element are ignored",
                                                              input_.remaining()));
    }

  private:
    const PlyElement& element() const { return plan_.header.elements[element_]; }
    PlyRole roleOf(std::size_t property) const { return plan_.roles[element_][property]; }

    [[noreturn]] void failEarly() const { throw InputError(endsEarly(element(), row_), {rows_.path}); }
    [[noreturn]] void failRow(std::string_view message) const {
        throw InputError(
            fmt::format("element '{}', row {} of {}: {}", element().name, row_ + 1, element().count, message),
            {rows_.path});
    }

    void skip(std::uint64_t count) {
        if (count > input_.remaining() || !input_.skip(count)) failEarly();
    }

    template <class To>
    To readNumber(PlyType type) {
        const std::string_view bytes = input_.peek(sizeof(double));
        return visitType(type, [&](auto value) {
            if (bytes.size() < sizeof value) failEarly();
            const To number = convertTo<To>(loadAs<decltype(value)>(bytes.data(), swaps_));
            input_.consume(sizeof value);
            return number;
        });
    }

    std::uint64_t readLength(const PlyProperty& property) {
        const auto length = readNumber<std::int64_t>(*property.countType);
        if (length < 0) failRow(fmt::format("a list has the length {}", length));
        return static_cast<std::uint64_t>(length);
    }

    /// Reads the next numbers of a list of `length`, as many as the buffer holds. Returns how many.
    template <class To>
    std::size_t readSome(PlyType type, std::uint64_t length, std::vector<To>& to) {
        const std::size_t size = sizeOf(type);
        const std::size_t wanted = std::min<std::uint64_t>(length, base::BlockReader::kBlock / size);
        const std::size_t count = std::min(wanted, input_.peek(wanted * size).size() / size);
        if (count == 0) failEarly();
        const char* const from = input_.peek(count * size).data();
        const std::size_t first = to.size();
        to.resize(first + count);
        visitType(type, [&](auto value) {
            for (std::size_t i = 0; i < count; ++i)
                to[first + i] = convertTo<To>(loadAs<decltype(value)>(from + i * sizeof value, swaps_));
        });
        input_.consume(count * size);
        return count;
    }

    template <class To>
    void readList(const PlyProperty& property, std::vector<To>& to) {
        to.clear();
        for (std::uint64_t left = readLength(property); left > 0;) left -= readSome(property.type, left, to);
    }

    void skipProperty(const PlyProperty& property) {
        const std::size_t size = sizeOf(property.type);
        skip(property.countType ? readLength(property) * size : size);
    }

    void skipElement() {
        if (!element().hasLists()) {
            const std::size_t row = element().smallestRow();
            if (row > 0 && element().count > input_.remaining() / row) {
                row_ = input_.remaining() / row;
                failEarly();
            }
            return skip(element().count * row);
        }
        for (; row_ < element().count; ++row_) {
            rows_.step.advanceTo(input_.offset());
            for (const PlyProperty& property : element().properties) skipProperty(property);
        }
    }

    void readVertices() {
        chunk_.lines.fill(0);
        if (element().hasLists()) return readVerticesWithLists();
        const std::size_t size = element().smallestRow();
        const std::size_t most = std::min(PlyVertices::kRows, base::BlockReader::kBlock / size);
        while (row_ < element().count) {
            const std::size_t wanted = std::min<std::uint64_t>(most, element().count - row_);
            const std::string_view bytes = input_.peek(wanted * size);
            chunk_.count = std::min(wanted, bytes.size() / size);
            std::size_t offset = 0;
            for (std::size_t i = 0; i < element().properties.size(); ++i) {
                const PlyType type = element().properties[i].type;
                readColumn(roleOf(i), type, bytes.data() + offset, size);
                offset += sizeOf(type);
            }
            input_.consume(chunk_.count * size);
            row_ += chunk_.count;
            if (chunk_.count < wanted) failEarly();
            rows_.mesh.addVertices(chunk_);
            rows_.step.advanceTo(input_.offset());
        }
    }

    void readColumn(PlyRole role, PlyType type, const char* from, std::size_t stride) {
        if (role >= PlyRole::Ignored) return;
        float* const to = chunk_.columns[static_cast<std::size_t>(role)].data();
        visitType(type, [&](auto value) {
            for (std::size_t i = 0; i < chunk_.count; ++i)
                to[i] = static_cast<float>(loadAs<decltype(value)>(from + i * stride, swaps_));
        });
    }

    void readVerticesWithLists() {
        chunk_.count = 1;
        for (; row_ < element().count; ++row_) {
            for (std::size_t i = 0; i < element().properties.size(); ++i) {
                const PlyProperty& property = element().properties[i];
                if (roleOf(i) >= PlyRole::Ignored)
                    skipProperty(property);
                else
                    chunk_.columns[static_cast<std::size_t>(roleOf(i))][0] = readNumber<float>(property.type);
            }
            rows_.mesh.addVertices(chunk_);
            rows_.step.advanceTo(input_.offset());
        }
    }

    void readFaces() {
        PlyFace face;
        for (; row_ < element().count; ++row_) {
            rows_.step.advanceTo(input_.offset());
            for (std::size_t i = 0; i < element().properties.size(); ++i) {
                const PlyProperty& property = element().properties[i];
                switch (roleOf(i)) {
                    case PlyRole::Indices:
                        readList(property, face.corners);
                        break;
                    case PlyRole::TexCoords:
                        readList(property, face.texCoords);
                        break;
                    case PlyRole::TexNumber:
                        face.textureNumber = readNumber<std::int64_t>(property.type);
                        break;
                    default:
                        skipProperty(property);
                }
            }
            if (const std::int64_t* bad = rows_.mesh.addFace(face)) failRow(badVertexIndex(plan_, *bad));
        }
    }

    void readStrips() {
        std::vector<std::int64_t> corners;
        for (; row_ < element().count; ++row_)
            for (std::size_t i = 0; i < element().properties.size(); ++i) {
                const PlyProperty& property = element().properties[i];
                if (roleOf(i) != PlyRole::Indices) {
                    skipProperty(property);
                    continue;
                }
                rows_.mesh.beginStrip();
                for (std::uint64_t left = readLength(property); left > 0;) {
                    corners.clear();
                    left -= readSome(property.type, left, corners);
                    rows_.step.advanceTo(input_.offset());
                    if (const std::int64_t* bad = rows_.mesh.addStripCorners(corners))
                        failRow(badVertexIndex(plan_, *bad));
                }
            }
    }

    const PlyRows& rows_;
    base::BlockReader& input_;
    const PlyPlan& plan_;
    const bool swaps_;
    std::size_t element_ = 0;
    std::uint64_t row_ = 0;
    PlyVertices chunk_;
};

}  // namespace

void readBinaryPly(const PlyRows& rows) { BinaryReader(rows).read(); }

}  // namespace rayscope::scene
