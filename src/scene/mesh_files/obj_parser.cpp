#include "scene/mesh_files/obj_parser.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "scene/mesh_files/tinyobj_tokenizer.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// Collects the statements of one file.
class ObjParser {
  public:
    explicit ObjParser(const std::string& path) : path_(path) {}

    ParsedObj parse() {
        const ObjCallbacks callbacks{
            .position = [this](const glm::vec3& position, int line) { addPosition(position, line); },
            .texCoord = [this](const glm::vec2& texCoord, int) { obj_.texCoords.push_back(texCoord); },
            .normal = [this](const glm::vec3& normal, int) { obj_.normals.push_back(normal); },
            .face = [this](std::span<const ObjIndices> corners, int line) { addFace(corners, line); },
            .useMaterial = [this](std::string_view name, int line) { useMaterial(name, line); },
            .materialLibrary =
                [this](std::string_view files, int line) {
                    obj_.libraries.push_back({std::string(files), line});
                },
            .unknown = [this](std::string_view keyword, int) { obj_.ignored.emplace(keyword); }};
        tokenizeObj(path_, readSource(path_), callbacks);
        return std::move(obj_);
    }

  private:
    void addPosition(const glm::vec3& position, int line) {
        if (!std::isfinite(position.x + position.y + position.z) && ++obj_.nonFiniteVertices == 1)
            obj_.firstNonFiniteVertex = line;
        obj_.positions.push_back(position);
    }

    void addFace(std::span<const ObjIndices> face, int line) {
        if (face.size() < 3) {
            if (++obj_.degenerateFaces == 1) obj_.firstDegenerateFace = line;
            return;
        }
        ring_.clear();
        for (const ObjIndices& indices : face) ring_.push_back(vertexOf(indices, line));
        if (ring_.size() > 3)
            obj_.polygons.push_back({static_cast<std::uint32_t>(obj_.triangles.size()),
                                     static_cast<std::uint32_t>(ring_.size())});
        for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
            obj_.triangles.emplace_back(ring_[0], ring_[i], ring_[i + 1]);
        addSlots(ring_.size() - 2);
    }

    std::uint32_t vertexOf(const ObjIndices& indices, int line) {
        const Corner corner{
            zeroBased(indices.position, obj_.positions.size(), "vertex", true, line),
            zeroBased(indices.texCoord, obj_.texCoords.size(), "texture coordinate", false, line),
            zeroBased(indices.normal, obj_.normals.size(), "normal", false, line),
        };
        const std::uint32_t vertex = obj_.corners.indexOf(corner);
        if (vertex == obj_.firstLines.size()) obj_.firstLines.push_back(line);
        return vertex;
    }

    /// Negative indices count back from the last element so far. Positive ones may refer to later elements
    /// and are checked when the file is complete.
    std::int32_t zeroBased(int index, std::size_t count, std::string_view what, bool isRequired,
                           int line) const {
        if (index > 0) return index - 1;
        if (index == 0 && !isRequired) return -1;
        if (index == 0 || static_cast<std::size_t>(-static_cast<std::int64_t>(index)) > count)
            failObjIndex(path_, line, what, index, count);
        return static_cast<std::int32_t>(static_cast<std::int64_t>(count) + index);
    }

    void useMaterial(std::string_view name, int line) {
        const auto [found, isNew] =
            slotOf_.try_emplace(std::string(name), static_cast<std::uint32_t>(obj_.slotNames.size()));
        if (isNew) {
            if (obj_.slotNames.size() > std::numeric_limits<std::uint16_t>::max())
                throw InputError("more than 65536 materials", {path_, line, 0});
            obj_.slotNames.push_back({std::string(name), line});
        }
        slot_ = found->second;
    }

    /// Appends the current slot for `count` triangles. The list stays empty until a second slot is used,
    /// because most files have one material.
    void addSlots(std::size_t count) {
        if (!slot_) {
            slot_ = static_cast<std::uint32_t>(obj_.slotNames.size());
            obj_.slotNames.push_back({"", 0});
        }
        if (obj_.slots.empty()) {
            if (*slot_ == 0) return;
            obj_.slots.assign(obj_.triangles.size() - count, 0);
        }
        obj_.slots.insert(obj_.slots.end(), count, static_cast<std::uint16_t>(*slot_));
    }

    const std::string& path_;
    ParsedObj obj_;
    std::vector<std::uint32_t> ring_;
    std::map<std::string, std::uint32_t> slotOf_;
    std::optional<std::uint32_t> slot_;
};

}  // namespace

ParsedObj parseObj(const std::string& path) { return ObjParser(path).parse(); }

void failObjIndex(const std::string& path, int line, std::string_view what, std::int64_t index,
                  std::size_t count) {
    const std::string range = count == 0 ? fmt::format("the file has no {}", what)
                                         : fmt::format("expected 1 to {0} or -{0} to -1", count);
    throw InputError(fmt::format("{} {} is out of range: {}", what, index, range), {path, line, 0});
}

}  // namespace rayscope::scene
