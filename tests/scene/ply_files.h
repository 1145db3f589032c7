#pragma once
// PLY files of any format, written row by row, and a fixture that loads them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "scene_files.h"

namespace rayscope::test {

class PlyFile {
  public:
    enum class Format { Ascii, LittleEndian, BigEndian };
    static constexpr std::array kFormats{Format::Ascii, Format::LittleEndian, Format::BigEndian};

    explicit PlyFile(Format format, std::string lineEnd = "\n")
        : format_(format), lineEnd_(std::move(lineEnd)) {
        constexpr const char* kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        line("ply");
        line(fmt::format("format {} 1.0", kNames[static_cast<int>(format)]));
    }

    PlyFile& comment(const std::string& text) { return line("comment " + text), *this; }

    /// `properties`: "TYPE NAME" or "list COUNT_TYPE TYPE NAME".
    PlyFile& element(const std::string& name, std::uint64_t count,
                     const std::vector<std::string>& properties) {
        line(fmt::format("element {} {}", name, count));
        std::vector<Types> types;
        for (const std::string& property : properties) {
            line("property " + property);
            const std::size_t start = property.starts_with("list ") ? 5 : 0;
            const std::size_t end = property.find(' ', start);
            Types type{property.substr(start, end - start), ""};
            if (start > 0) type.value = property.substr(end + 1, property.find(' ', end + 1) - end - 1);
            types.push_back(type);
        }
        elements_.push_back({count, types});
        return *this;
    }

    /// The values of the next row: one number per property, or the length and the numbers of a list.
    PlyFile& row(const std::vector<std::vector<double>>& values) {
        while (elements_[element_].count == rows_ || elements_[element_].types.empty()) ++element_, rows_ = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            for (std::size_t k = 0; k < values[i].size(); ++k) {
                const Types& types = elements_[element_].types[i];
                number(k == 0 ? types.first : types.value, values[i][k]);
            }
        if (format_ == Format::Ascii) body_.back() = '\n';
        ++rows_;
        return *this;
    }

    std::string bytes() const { return header_ + "end_header" + lineEnd_ + body_; }

  private:
    struct Types {
        std::string first, value;
    };
    struct Element {
        std::uint64_t count;
        std::vector<Types> types;
    };

    void line(const std::string& text) { header_ += text + lineEnd_; }

    template <class T>
    void put(double value) {
        char bytes[sizeof(T)];
        const T typed = static_cast<T>(value);
        std::memcpy(bytes, &typed, sizeof typed);
        if ((format_ == Format::BigEndian) != (std::endian::native == std::endian::big))
            std::reverse(bytes, bytes + sizeof bytes);
        body_.append(bytes, sizeof bytes);
    }

    void number(const std::string& type, double value) {
        if (format_ == Format::Ascii) {
            body_ += fmt::format("{} ", value);
            return;
        }
        const auto is = [&](const char* name, const char* other) { return type == name || type == other; };
        if (is("char", "int8")) return put<std::int8_t>(value);
        if (is("uchar", "uint8")) return put<std::uint8_t>(value);
        if (is("short", "int16")) return put<std::int16_t>(value);
        if (is("ushort", "uint16")) return put<std::uint16_t>(value);
        if (is("int", "int32")) return put<std::int32_t>(value);
        if (is("uint", "uint32")) return put<std::uint32_t>(value);
        if (is("float", "float32")) return put<float>(value);
        put<double>(value);
    }

    Format format_;
    std::string lineEnd_, header_, body_;
    std::vector<Element> elements_;
    std::size_t element_ = 0;
    std::uint64_t rows_ = 0;
};

/// A fixture that loads PLY files.
class PlyFiles : public SceneFiles {
  protected:
    SceneDescription read(std::string_view content) {
        notes_.clear();
        return load(write("mesh.ply", content));
    }
    std::string failure(std::string_view content) { return errorOf(write("mesh.ply", content)); }
    static const MeshData& meshOf(const SceneDescription& scene) { return *scene.meshes.at(0).data; }
};

inline const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string kList = "property list uchar int vertex_indices\n";
inline const std::string kThree = "0 0 0\n1 0 0\n0 1 0\n";

/// The header of an ASCII file.
inline std::string header(int vertices, const std::string& properties, int faces,
                          const std::string& list = kList) {
    return fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n{}element face {}\n{}end_header\n",
                       vertices, properties, faces, list);
}
/// A whole file: one triangle, 13 lines.
inline const std::string kPlyTriangle = header(3, kXyz, 1) + kThree + "3 0 1 2\n";

}  // namespace rayscope::test
