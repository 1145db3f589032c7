#include "scene/obj_parser.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "scene/obj_lines.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// The words of a line behind its keyword, without the blanks around them.
std::string_view argumentOf(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const auto trim = [&](std::string_view text) {
        const std::size_t first = text.find_first_not_of(kBlanks);
        if (first == std::string_view::npos) return std::string_view{};
        return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
    };
    line = trim(line);
    const std::size_t blank = line.find_first_of(kBlanks);
    return blank == std::string_view::npos ? std::string_view{} : trim(line.substr(blank));
}

/// Whether the line holds at least so many words, all of digits, signs, points and exponents.
bool looksLikeNumbers(std::string_view line, int atLeast) {
    int words = 0;
    bool isInWord = false;
    for (const char c : line) {
        const bool isBlank = c == ' ' || c == '\t';
        if (!isBlank && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.' && c != 'e' && c != 'E')
            return false;
        words += !isBlank && !isInWord;
        isInWord = !isBlank;
    }
    return words >= atLeast;
}

/// Listens to tinyobjloader.
class ObjParser {
  public:
    explicit ObjParser(const std::string& path)
        : path_(path),
          text_(readSource(path)),
          lines_(text_, [this](std::string_view line) { readOther(line); }) {}

    ParsedObj parse() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float x, float y, float z, float) {
            of(self).addPosition({x, y, z});
        };
        callbacks.texcoord_cb = [](void* self, float x, float y, float) { of(self).addTexCoord({x, y}); };
        callbacks.normal_cb = [](void* self, float x, float y, float z) { of(self).addNormal({x, y, z}); };
        callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            of(self).addFace({indices, static_cast<std::size_t>(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char*, int) { of(self).useMaterial(); };
        std::istream stream(&lines_);
        stream.imbue(std::locale::classic());
        tinyobj::LoadObjWithCallback(stream, callbacks, this);
        return std::move(obj_);
    }

  private:
    static ObjParser& of(void* self) { return *static_cast<ObjParser*>(self); }

    [[noreturn]] void fail(std::string message) const {
        throw InputError(std::move(message), {path_, lines_.line(), 0});
    }
    void addPosition(glm::vec3 position) {
        correct(position, 3);
        if (!std::isfinite(position.x + position.y + position.z) && ++obj_.nonFiniteVertices == 1)
            obj_.firstNonFiniteVertex = lines_.line();
        obj_.positions.push_back(position);
    }
    void addTexCoord(glm::vec2 texCoord) {
        glm::vec3 value(texCoord, 0.0f);
        correct(value, 1);
        obj_.texCoords.emplace_back(value);
    }
    void addNormal(glm::vec3 normal) {
        correct(normal, 3);
        obj_.normals.push_back(normal);
    }

    /// The library reads what it does not understand as 0. Numbers consist of digits, signs, points and
    /// exponents; a line with anything else is read again here: nan and inf are kept, words are errors.
    void correct(glm::vec3& value, int atLeast) {
        const std::string_view line = argumentOf(lines_.current());
        if (looksLikeNumbers(line, atLeast)) return;
        const char* at = line.data();
        const char* const end = at + line.size();
        for (int i = 0; i < 3; ++i) {
            while (at != end && (*at == ' ' || *at == '\t')) ++at;
            if (at == end) {
                if (i < atLeast) fail(fmt::format("expected {} numbers, got {}", atLeast, i));
                return;
            }
            if (*at == '+') ++at;
            const auto [stop, error] = std::from_chars(at, end, value[i]);
            if (error == std::errc::result_out_of_range)
                value[i] = std::numeric_limits<float>::infinity();
            else if (error != std::errc{})
                fail(fmt::format("expected a number, got '{}'",
                                 line.substr(static_cast<std::size_t>(at - line.data()))));
            at = stop;
        }
    }

    void addFace(std::span<const tinyobj::index_t> face) {
        if (face.size() < 3) {
            if (++obj_.degenerateFaces == 1) obj_.firstDegenerateFace = lines_.line();
            return;
        }
        checkDigits(argumentOf(lines_.current()));
        ring_.clear();
        for (const tinyobj::index_t& index : face) ring_.push_back(vertexOf(index));
        if (ring_.size() > 3)
            obj_.polygons.push_back({static_cast<std::uint32_t>(obj_.triangles.size()),
                                     static_cast<std::uint32_t>(ring_.size())});
        for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
            obj_.triangles.emplace_back(ring_[0], ring_[i], ring_[i + 1]);
        addSlots(ring_.size() - 2);
    }

    /// The library reads numbers that no int can hold as some other number.
    void checkDigits(std::string_view line) const {
        std::size_t digits = 0;
        for (const char c : line) {
            digits = c >= '0' && c <= '9' ? digits + 1 : 0;
            if (digits > std::numeric_limits<int>::digits10) fail("an index has more than nine digits");
        }
    }

    std::uint32_t vertexOf(const tinyobj::index_t& index) {
        const Corner corner{
            zeroBased(index.vertex_index, obj_.positions.size(), "vertex", true),
            zeroBased(index.texcoord_index, obj_.texCoords.size(), "texture coordinate", false),
            zeroBased(index.normal_index, obj_.normals.size(), "normal", false),
        };
        const std::uint32_t number = obj_.corners.indexOf(corner);
        if (number == obj_.firstLines.size()) obj_.firstLines.push_back(lines_.line());
        return number;
    }

    /// Positive indices may point ahead and are checked at the end; negative ones count back from here.
    std::int32_t zeroBased(int index, std::size_t count, std::string_view what, bool needed) const {
        if (index > 0) return index - 1;
        if (index == 0 && !needed) return -1;
        if (index == 0 || static_cast<std::size_t>(-static_cast<std::int64_t>(index)) > count)
            failObjIndex(path_, lines_.line(), what, index, count);
        return static_cast<std::int32_t>(static_cast<std::int64_t>(count) + index);
    }
    void useMaterial() {
        // The library would cut the name of the material at nothing, blanks at the end included.
        const std::string name(argumentOf(lines_.current()));
        const auto [found, isNew] =
            slotOf_.try_emplace(name, static_cast<std::uint32_t>(obj_.slotNames.size()));
        if (isNew) {
            if (obj_.slotNames.size() > std::numeric_limits<std::uint16_t>::max())
                fail("more than 65536 materials");
            obj_.slotNames.push_back({name, lines_.line()});
        }
        slot_ = found->second;
    }

    /// Slots are written only once a second one is in use; most files have one material.
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

    /// Lines that are no vertices and faces: the library either says nothing about them or not enough.
    void readOther(std::string_view line) {
        const std::string keyword(line.substr(0, line.find_first_of(" \t\r\n")));
        if (keyword == "mtllib")
            obj_.libraries.push_back({std::string(argumentOf(line)), lines_.line()});
        else if (keyword != "usemtl" && keyword != "o" && keyword != "g" && keyword != "s")
            obj_.ignored.insert(keyword);
    }

    const std::string& path_;
    std::string text_;
    ObjLines lines_;
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
