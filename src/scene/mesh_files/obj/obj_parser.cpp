#include "scene/mesh_files/obj/obj_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/parse_float.h"
#include "scene/load_step.h"
#include "scene/mesh_files/obj/obj_corner.h"
#include "scene/mesh_files/obj/obj_references.h"
#include "scene/mesh_files/obj/obj_statements.h"
#include "scene/mesh_files/text/text_lines.h"

namespace rayscope::scene {

namespace {

constexpr std::size_t kShortestVertex = 8;  ///< bytes of "v 0 0 0" and its line end
constexpr std::int64_t kMaxIndex = std::numeric_limits<std::int32_t>::max();

class ObjParser {
  public:
    ObjParser(const std::string& path, std::string_view text, Oddities& oddities, const LoadControl& control)
        : path_(path),
          lines_(path, text),
          oddities_(oddities),
          statements_(path),
          step_(control, "parsing " + path.substr(path.find_last_of('/') + 1), text.size()),
          corners_(text.size() / kShortestVertex + 1) {}

    ParsedObj parse() {
        while (lines_.next()) {
            step_.advanceTo(lines_.offset());
            parseLine(lines_.line());
        }
        finish();
        return std::move(obj_);
    }

  private:
    void parseLine(std::string_view line) {
        const auto isKeyword = [&](std::size_t length) {
            return line.size() == length || isBlank(line[length]);
        };
        if (line.front() == 'v') {
            if (isKeyword(1)) return addPosition(line.substr(1));
            if (line[1] == 'n' && isKeyword(2)) return addNormal(line.substr(2));
            if (line[1] == 't' && isKeyword(2)) return addTexCoord(line.substr(2));
        }
        if (line.front() == 'f' && isKeyword(1)) return addFace(line.substr(1));
        Words words(line);
        const std::string_view keyword = words.next();
        if (keyword == "fo") return addFace(words.rest());  // an old name of f
        if (keyword == "usemtl") return useMaterial(trimmed(words.rest()));
        if (keyword == "mtllib")
            obj_.libraries.push_back({std::string(trimmed(words.rest())), lines_.number()});
        else
            statements_.add(keyword, trimmed(words.rest()), lines_.number());
    }

    /// Numbers of a statement: at least `required`, at most values.size(). Words behind the required numbers
    /// that are no numbers are ignored with a warning.
    template <std::size_t Count>
    std::size_t parseNumbers(std::string_view arguments, std::size_t required,
                             std::array<float, Count>& values) {
        Words words(arguments);
        std::size_t count = 0;
        for (std::string_view word = words.next(); !word.empty() && word.front() != '#';
             word = words.next()) {
            std::optional<float> value = base::parseFloat(word);
            if (const std::size_t hash = word.find('#'); !value && hash != std::string_view::npos) {
                value = base::parseFloat(word.substr(0, hash));  // a comment without a blank before it
                if (value) words.stop();
            }
            if (!value && count >= required) {
                oddities_.add(Severity::Warning, "words behind the numbers of a statement; ignored",
                              lines_.number());
                break;
            }
            if (!value) failNumber(word);
            if (count < Count) values[count] = *value;
            ++count;
        }
        if (count < required)
            throw InputError(
                fmt::format("expected {} number{}, got {}", required, required == 1 ? "" : "s", count),
                lines_.positionOf(arguments.data()));
        return count;
    }

    [[noreturn]] void failNumber(std::string_view word) const {
        const bool hasComma = word.find(',') != std::string_view::npos;
        throw InputError(fmt::format("expected a number, got '{}'{}", word,
                                     hasComma ? "; the decimal separator is a point" : ""),
                         lines_.positionOf(word.data()));
    }

    void addPosition(std::string_view arguments) {
        std::array<float, 7> v;
        const std::size_t count = parseNumbers(arguments, 3, v);
        if (!std::isfinite(v[0] + v[1] + v[2]) &&
            !(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2])))
            oddities_.add(Severity::Note,
                          "vertices with NaN or infinite coordinates; rays never hit their triangles",
                          lines_.number());
        obj_.positions.emplace_back(v[0], v[1], v[2]);
        if (count > 3) addExtraNumbers(v, count);
    }

    /// Behind x y z: a weight w, or a colour r g b, with or without alpha. The weight is one of rational
    /// curves and has no effect on polygons.
    void addExtraNumbers(const std::array<float, 7>& v, std::size_t count) {
        if (count >= 6) {
            constexpr float kNotGiven = std::numeric_limits<float>::quiet_NaN();
            obj_.colors.resize(obj_.positions.size() - 1, Rgb(kNotGiven));
            obj_.colors.emplace_back(v[3], v[4], v[5]);
        }
        if (count == 4 && v[3] != 1.0f)
            oddities_.add(Severity::Note, "vertices with a weight other than 1; the weight is ignored",
                          lines_.number());
        if (count == 5)
            oddities_.add(Severity::Warning, "vertices with 5 numbers; the last two are ignored",
                          lines_.number());
        if (count > 6)
            oddities_.add(Severity::Note, "vertices with numbers behind the colour; these are ignored",
                          lines_.number());
    }

    void addNormal(std::string_view arguments) {
        std::array<float, 3> v;
        parseNumbers(arguments, 3, v);
        obj_.normals.emplace_back(v[0], v[1], v[2]);
    }

    void addTexCoord(std::string_view arguments) {
        std::array<float, 3> v{};
        parseNumbers(arguments, 1, v);
        for (int axis = 0; axis < 2; ++axis)
            if (float& value = v[static_cast<std::size_t>(axis)]; !std::isfinite(value)) {
                oddities_.add(Severity::Warning, "texture coordinates that are not finite; 0 is used",
                              lines_.number());
                value = 0.0f;
            }
        obj_.texCoords.emplace_back(v[0], v[1]);
    }

    void addFace(std::string_view arguments) {
        face_.clear();
        Words words(arguments);
        WrittenCorner corner;
        for (std::string_view word = words.next(); !word.empty() && word.front() != '#';
             word = words.next()) {
            if (!parseCorner(word, corner)) {
                const std::size_t hash = word.find('#');  // a comment without a blank before it
                if (hash == std::string_view::npos || !parseCorner(word.substr(0, hash), corner))
                    throw InputError(cornerError(word), lines_.positionOf(word.data()));
                words.stop();
            }
            face_.push_back({positionIndex(corner.position, word),
                             optionalIndex(corner.texCoord, obj_.texCoords.size(), texCoords_),
                             optionalIndex(corner.normal, obj_.normals.size(), normals_)});
        }
        if (face_.size() < 3) return statements_.addThinFace(lines_.number());
        if (face_.size() > 3)
            obj_.polygons.push_back({static_cast<std::uint32_t>(obj_.triangles.size()),
                                     static_cast<std::uint32_t>(face_.size()), lines_.number()});
        const std::uint32_t first = corners_.indexOf(face_[0]);
        std::uint32_t last = corners_.indexOf(face_[1]);
        for (std::size_t i = 2; i < face_.size(); ++i) {
            const std::uint32_t next = corners_.indexOf(face_[i]);
            obj_.triangles.emplace_back(first, last, next);
            last = next;
        }
        addSlots(face_.size() - 2);
    }

    /// Zero-based. Negative indices count back from the last element so far. Positive ones may refer to later
    /// elements and are checked when the file is complete.
    std::int32_t positionIndex(std::int64_t index, std::string_view word) {
        const std::size_t count = obj_.positions.size();
        if (index > 0 && index <= kMaxIndex) {
            if (static_cast<std::size_t>(index) > count && positions_.exceeds(index)) {
                const SourcePosition at = lines_.positionOf(word.data());
                positions_.add(index, at.line, at.column);
            }
            return static_cast<std::int32_t>(index - 1);
        }
        const std::int64_t fromStart = static_cast<std::int64_t>(count) + index;
        if (index < 0 && fromStart >= 0) return static_cast<std::int32_t>(fromStart);
        failPosition(word.substr(0, word.find_first_of("/#")), lines_.positionOf(word.data()),
                     index < 0 ? " so far" : "");
    }

    [[noreturn]] void failPosition(std::string_view index, SourcePosition position,
                                   std::string_view when) const {
        const std::size_t count = obj_.positions.size();
        const std::string range = count == 0 ? fmt::format("the file has no vertex{}", when)
                                             : fmt::format("expected 1 to {0} or -{0} to -1{1}", count, when);
        throw InputError(fmt::format("vertex {} is out of range: {}", index, range), std::move(position));
    }

    /// Zero-based; −1: none.
    std::int32_t optionalIndex(const std::optional<std::int64_t>& index, std::size_t count,
                               OptionalReferences& elements) {
        if (!index) return -1;
        if (*index > 0 && *index <= kMaxIndex) {
            if (static_cast<std::size_t>(*index) > count && elements.forward.exceeds(*index))
                elements.forward.add(*index, lines_.number(), 0);
            return static_cast<std::int32_t>(*index - 1);
        }
        const std::int64_t fromStart = static_cast<std::int64_t>(count) + *index;
        if (*index < 0 && fromStart >= 0) return static_cast<std::int32_t>(fromStart);
        elements.missing.add(lines_.number());
        return -1;
    }

    void useMaterial(std::string_view name) {
        const auto [found, isNew] =
            slotOf_.try_emplace(std::string(name), static_cast<std::uint32_t>(obj_.slotNames.size()));
        if (isNew) addSlotName(std::string(name), lines_.number());
        slot_ = found->second;
    }

    void addSlotName(std::string name, int line) {
        if (obj_.slotNames.size() > std::numeric_limits<std::uint16_t>::max())
            throw InputError("more than 65536 materials", lines_.positionOf(lines_.line().data()));
        obj_.slotNames.push_back({std::move(name), line});
    }

    /// Appends the current slot for `count` triangles. The list stays empty until a second slot is used,
    /// because most files have one material.
    void addSlots(std::size_t count) {
        if (!slot_) {
            slot_ = static_cast<std::uint32_t>(obj_.slotNames.size());
            addSlotName("", 0);
        }
        if (obj_.slots.empty()) {
            if (*slot_ == 0) return;
            obj_.slots.assign(obj_.triangles.size() - count, 0);
        }
        obj_.slots.insert(obj_.slots.end(), count, static_cast<std::uint16_t>(*slot_));
    }

    /// Checks what depends on the whole file.
    void finish() {
        if (const auto* reference = positions_.firstBeyond(obj_.positions.size()))
            failPosition(std::to_string(reference->index), {path_, reference->line, reference->column}, "");
        if (obj_.triangles.empty()) statements_.failWithoutFaces(obj_.positions.size());
        obj_.corners = corners_.takeCorners();
        if (!obj_.colors.empty())
            obj_.colors.resize(obj_.positions.size(), Rgb(std::numeric_limits<float>::quiet_NaN()));
        dropMissing(&Corner::texCoord, obj_.texCoords.size(), texCoords_);
        dropMissing(&Corner::normal, obj_.normals.size(), normals_);
        statements_.report(!obj_.normals.empty(), oddities_);
    }

    void dropMissing(std::int32_t Corner::*index, std::size_t count, OptionalReferences& elements) {
        if (const auto* reference = elements.forward.firstBeyond(count)) {
            for (Corner& corner : obj_.corners)
                if (corner.*index >= 0 && static_cast<std::size_t>(corner.*index) >= count) {
                    corner.*index = -1;
                    elements.missing.add(reference->line);
                }
        }
        const MissingElements& missing = elements.missing;
        oddities_.add(Severity::Warning,
                      fmt::format("corners with a {} that does not exist (the file has {}); ignored",
                                  missing.what, count),
                      missing.firstLine, missing.count);
    }

    const std::string& path_;
    TextLines lines_;
    Oddities& oddities_;
    ObjStatements statements_;
    LoadStep step_;
    ParsedObj obj_;
    CornerTable corners_;
    std::vector<Corner> face_;
    ForwardReferences positions_;
    OptionalReferences texCoords_{{}, {"texture coordinate"}}, normals_{{}, {"normal"}};
    std::map<std::string, std::uint32_t, std::less<>> slotOf_;
    std::optional<std::uint32_t> slot_;
};

}  // namespace

ParsedObj parseObj(const std::string& path, std::string_view text, Oddities& oddities,
                   const LoadControl& control) {
    return ObjParser(path, text, oddities, control).parse();
}

}  // namespace rayscope::scene
