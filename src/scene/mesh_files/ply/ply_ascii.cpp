#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/parse_float.h"
#include "scene/mesh_files/ply/ply_rows.h"
#include "scene/mesh_files/text/word_reader.h"

namespace rayscope::scene {

namespace {

class PlyAsciiReader {
  public:
    PlyAsciiReader(const PlyRows& rows, PlyLayout layout)
        : rows_(rows),
          plan_(rows.plan),
          layout_(layout),
          words_(rows.path, rows.input, rows.plan.header.lines + 1) {}

    void read() {
        try {
            readElements();
        } catch (const InputError& error) {
            // Rows that share a line lead to any error further down.
            if (hasExtraWords_) throw PlyLayoutError{error};
            throw;
        }
    }

  private:
    void readElements() {
        const std::vector<PlyElement>& elements = plan_.header.elements;
        for (element_ = 0; element_ < elements.size(); ++element_) {
            if (elements[element_].properties.empty()) continue;
            if (element_ == plan_.vertices)
                readVertices();
            else if (element_ == plan_.faces)
                readFaces();
            else if (element_ == plan_.strips)
                readStrips();
            else
                forEachRow([&](std::size_t i) { skipProperty(i); }, [] {});
        }
        if (words_.next().empty()) return;
        if (layout_ == PlyLayout::Words) words_.fail("text behind the last element");
        rows_.oddities.add(Severity::Warning, "text behind the last element is ignored", words_.line());
    }

    const PlyElement& element() const { return plan_.header.elements[element_]; }
    const PlyProperty& property(std::size_t i) const { return element().properties[i]; }
    PlyRole roleOf(std::size_t i) const { return plan_.roles[element_][i]; }

    /// Calls readProperty for each property of each row, and endRow behind each row.
    template <class ReadProperty, class EndRow>
    void forEachRow(const ReadProperty& readProperty, const EndRow& endRow) {
        const std::size_t properties = element().properties.size();
        for (row_ = 0; row_ < element().count; ++row_) {
            rows_.step.advanceTo(words_.offset());
            isFirst_ = true;
            for (std::size_t i = 0; i < properties; ++i) readProperty(i);
            endRow();
            if (layout_ == PlyLayout::Lines && !words_.nextInLine().empty()) skipExtraWords();
        }
    }

    void skipExtraWords() {
        hasExtraWords_ = true;
        rows_.oddities.add(Severity::Warning,
                           "lines with more values than the header announces; the rest of them is ignored",
                           words_.line());
        words_.skipLine();
    }

    std::string_view word() {
        const bool crossesLines = isFirst_ || layout_ == PlyLayout::Words;
        const std::string_view word = crossesLines ? words_.next() : words_.nextInLine();
        if (word.empty()) failWithoutWord(crossesLines);
        isFirst_ = false;
        return word;
    }

    [[noreturn]] void failWithoutWord(bool isEndOfFile) const {
        if (!isEndOfFile)
            throw PlyLayoutError{
                InputError(fmt::format("the line of a row of '{}' has too few values", element().name),
                           words_.position())};
        throw InputError(endsEarly(element(), row_), {rows_.path, words_.line()});
    }

    [[noreturn]] void failNumber(std::string_view word) const {
        const bool hasComma = word.find(',') != std::string_view::npos;
        words_.fail(fmt::format("invalid number '{}'{}", shown(word),
                                hasComma ? "; the decimal separator is a point" : ""));
    }

    float readFloat() {
        const std::string_view text = word();
        const std::optional<float> value = base::parseFloat(text);
        if (!value) failNumber(text);
        return *value;
    }

    /// kNoInteger for other numbers.
    std::int64_t readInteger() {
        const std::string_view text = word();
        const std::size_t sign = text.starts_with('+') ? 1 : 0;
        std::int64_t value = 0;
        const auto [stop, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
        if (error == std::errc{} && stop == text.data() + text.size()) return value;
        const std::optional<float> number = base::parseFloat(text);
        if (!number) failNumber(text);
        const bool isExact = std::abs(*number) < 0x1p24f && *number == std::floor(*number);
        return isExact ? static_cast<std::int64_t>(*number) : kNoInteger;
    }

    std::uint64_t readLength() {
        const std::int64_t length = readInteger();
        if (length == kNoInteger) words_.fail("the length of a list is not an integer");
        if (length < 0) words_.fail(fmt::format("a list has the length {}", length));
        return static_cast<std::uint64_t>(length);
    }

    void skipProperty(std::size_t i) {
        for (std::uint64_t left = property(i).countType ? readLength() : 1; left > 0; --left) word();
    }

    void readVertices() {
        chunk_.count = 0;
        const auto readProperty = [&](std::size_t i) {
            if (roleOf(i) >= PlyRole::Ignored) return skipProperty(i);
            chunk_.columns[static_cast<std::size_t>(roleOf(i))][chunk_.count] = readFloat();
        };
        forEachRow(readProperty, [&] {
            chunk_.lines[chunk_.count] = words_.line();
            if (++chunk_.count == PlyVertices::kRows) addChunk();
        });
        addChunk();
    }

    void addChunk() {
        rows_.mesh.addVertices(chunk_);
        chunk_.count = 0;
    }

    void readFaces() {
        PlyFace face;
        const auto readProperty = [&](std::size_t i) {
            switch (roleOf(i)) {
                case PlyRole::Indices:
                    face.corners.clear();
                    for (std::uint64_t left = readLength(); left > 0; --left)
                        face.corners.push_back(readInteger());
                    break;
                case PlyRole::TexCoords:
                    face.texCoords.clear();
                    for (std::uint64_t left = readLength(); left > 0; --left)
                        face.texCoords.push_back(readFloat());
                    break;
                case PlyRole::TexNumber:
                    face.textureNumber = readInteger();
                    break;
                default:
                    skipProperty(i);
            }
        };
        forEachRow(readProperty, [&] {
            face.line = words_.line();
            if (const std::int64_t* bad = rows_.mesh.addFace(face)) failIndex(*bad);
        });
    }

    void readStrips() {
        const auto readProperty = [&](std::size_t i) {
            if (roleOf(i) != PlyRole::Indices) return skipProperty(i);
            rows_.mesh.beginStrip();
            for (std::uint64_t left = readLength(); left > 0; --left) {
                const std::int64_t corner = readInteger();
                rows_.step.advanceTo(words_.offset());
                if (const std::int64_t* bad = rows_.mesh.addStripCorners({&corner, 1})) failIndex(*bad);
            }
        };
        forEachRow(readProperty, [] {});
    }

    [[noreturn]] void failIndex(std::int64_t index) const {
        throw InputError(badVertexIndex(plan_, index), {rows_.path, words_.line()});
    }

    const PlyRows& rows_;
    const PlyPlan& plan_;
    const PlyLayout layout_;
    WordReader words_;
    std::size_t element_ = 0;
    std::uint64_t row_ = 0;
    bool isFirst_ = true;         ///< the next word is the first of its row
    bool hasExtraWords_ = false;  ///< some line had more words than its row
    PlyVertices chunk_;
};

}  // namespace

void readAsciiPly(const PlyRows& rows, PlyLayout layout) { PlyAsciiReader(rows, layout).read(); }

}  // namespace rayscope::scene
