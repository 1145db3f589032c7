#pragma once
// Writes small glTF files.
#include <fmt/format.h>

#include <cstring>
#include <string>
#include <vector>

#include "scene_files.h"

namespace rayscope::test {

inline const std::string kPositions = R"("attributes":{"POSITION":0})";

/// A glTF document under construction: each accessor gets a view of its own.
class GltfBuilder {
  public:
    template <class T>
    static constexpr int kComponent = std::is_same_v<T, std::int8_t>     ? 5120
                                      : std::is_same_v<T, std::uint8_t>  ? 5121
                                      : std::is_same_v<T, std::int16_t>  ? 5122
                                      : std::is_same_v<T, std::uint16_t> ? 5123
                                      : std::is_same_v<T, std::uint32_t> ? 5125
                                                                         : 5126;

    /// Appends bytes at a multiple of 4 as a view; returns its index.
    int view(std::string_view bytes, const std::string& members = "") {
        binary_.resize((binary_.size() + 3) / 4 * 4);
        views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", binary_.size(),
                                     bytes.size(), members));
        binary_ += bytes;
        return static_cast<int>(views_.size()) - 1;
    }

    /// An accessor of all values; `members` begins with a comma.
    template <class T>
    int accessor(const std::vector<T>& values, const std::string& type, const std::string& members = "") {
        const std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        const auto size = static_cast<std::size_t>(type[3] - '0');
        const std::size_t components = type == "SCALAR" ? 1 : type.starts_with("MAT") ? size * size : size;
        return declare(fmt::format(R"("bufferView":{},"componentType":{},"count":{},"type":"{}"{})",
                                   view(bytes), kComponent<T>, values.size() / components, type, members));
    }
    int declare(const std::string& members) {
        accessors_.push_back("{" + members + "}");
        return static_cast<int>(accessors_.size()) - 1;
    }

    /// The JSON with this member "uri" of the buffer.
    std::string json(const std::string& members, const std::string& uri) const {
        return fmt::format(
            R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{}}}],"bufferViews":[{}],)"
            R"("accessors":[{}],{}}})",
            binary_.size(), uri.empty() ? "" : fmt::format(R"(,"uri":"{}")", uri), fmt::join(views_, ","),
            fmt::join(accessors_, ","), members);
    }
    std::string embedded(const std::string& members) const {
        return json(members, "data:application/octet-stream;base64," + base64(binary_));
    }
    std::string glb(const std::string& members) const { return container(json(members, ""), binary_); }
    const std::string& binary() const { return binary_; }

    static std::string word(std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        std::string bytes(4, '\0');
        std::memcpy(bytes.data(), &number, 4);
        return bytes;
    }
    static std::string container(std::string text, std::string binary) {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4);
        const std::string body =
            word(text.size()) + "JSON" + text + word(binary.size()) + std::string("BIN\0", 4) + binary;
        return "glTF" + word(2) + word(12 + body.size()) + body;
    }
    static std::string base64(std::string_view bytes) {
        constexpr std::string_view kDigits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k)
                bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
            for (std::size_t k = 0; k < 4; ++k)
                text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
        }
        return text;
    }

  private:
    std::string binary_;
    std::vector<std::string> views_, accessors_;
};

class GltfFiles : public SceneFiles {
  protected:
    static constexpr std::string_view kNode = R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])";

    /// Members of a document with one mesh of one primitive.
    static std::string oneMesh(const std::string& primitive, const std::string& others = std::string(kNode)) {
        return fmt::format(R"("meshes":[{{"primitives":[{{{}}}]}}],{})", primitive, others);
    }
    /// The triangle (0 0 0) (1 0 0) (0 1 0) as accessor 0.
    static GltfBuilder triangle() {
        GltfBuilder file;
        file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
        return file;
    }
    SceneDescription read(const std::string& text) { return load(write("m.gltf", text)); }
    std::string failure(const std::string& text) { return errorOf(write("m.gltf", text)); }
    static const MeshData& meshOf(const SceneDescription& scene) { return *scene.meshes.at(0).data; }
};

}  // namespace rayscope::test
