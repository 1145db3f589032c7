#include "scene/mesh_files/ply/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>

#include "base/lower_case.h"
#include "base/nearest_name.h"
#include "scene/mesh_files/text/foreign_format.h"
#include "scene/mesh_files/text/word_reader.h"

namespace rayscope::scene {

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array kTypeNames{
    TypeName{"char", PlyType::Int8},       TypeName{"uchar", PlyType::UInt8},
    TypeName{"short", PlyType::Int16},     TypeName{"ushort", PlyType::UInt16},
    TypeName{"int", PlyType::Int32},       TypeName{"uint", PlyType::UInt32},
    TypeName{"float", PlyType::Float32},   TypeName{"double", PlyType::Float64},
    TypeName{"int8", PlyType::Int8},       TypeName{"uint8", PlyType::UInt8},
    TypeName{"int16", PlyType::Int16},     TypeName{"uint16", PlyType::UInt16},
    TypeName{"int32", PlyType::Int32},     TypeName{"uint32", PlyType::UInt32},
    TypeName{"float32", PlyType::Float32}, TypeName{"float64", PlyType::Float64},
};

constexpr std::array<std::string_view, 3> kFormatNames{"ascii", "binary_little_endian", "binary_big_endian"};
constexpr std::array<std::string_view, 6> kKeywords{"format",  "comment",  "obj_info",
                                                    "element", "property", "end_header"};

std::vector<std::string_view> wordsOf(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\v\f\r";
    std::vector<std::string_view> words;
    for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

class HeaderReader {
  public:
    HeaderReader(const std::string& path, base::BlockReader& input, Oddities& oddities)
        : path_(path), input_(input), oddities_(oddities) {}

    PlyHeader read() {
        readMagic();
        for (;;) {
            const std::string text = nextLine();
            const std::vector<std::string_view> words = wordsOf(text);
            if (words.empty()) continue;
            const std::string keyword = base::lowerCase(words[0]);
            if (keyword == "end_header") break;
            readStatement(keyword, words, text);
        }
        if (!format_) fail("the header has no line 'format ascii 1.0' or 'format binary_little_endian 1.0'");
        header_.format = *format_;
        header_.lines = line_;
        return std::move(header_);
    }

  private:
    [[noreturn]] void fail(std::string message) const {
        throw InputError(std::move(message), {path_, line_});
    }

    /// The first line; it decides whether lines end with a lone CR.
    void readMagic() {
        constexpr std::string_view kMark = "\xef\xbb\xbf";
        const std::string_view start = input_.peek(512);
        const std::size_t mark = start.starts_with(kMark) ? kMark.size() : 0;
        const std::string_view magic = start.substr(mark, 3);
        const char behind = start.size() > mark + 3 ? start[mark + 3] : '\n';
        if (base::lowerCase(magic) != "ply" || static_cast<unsigned char>(behind) > ' ')
            throw InputError(describeForeign(start, "PLY", "does not begin with the line 'ply'"), {path_});
        const std::size_t end = start.find_first_of("\r\n", mark);
        endsWithCr_ = end != std::string_view::npos && start[end] == '\r' && start.substr(end, 2) != "\r\n";
        nextLine();
    }

    std::string nextLine() {
        const char lineBreak = endsWithCr_ ? '\r' : '\n';
        std::string_view text = input_.peek(1);
        if (text.empty()) fail("the file ends in its header: there is no line 'end_header'");
        std::size_t end = text.find(lineBreak);
        if (end == std::string_view::npos) {
            text = input_.peek(base::BlockReader::kBlock);
            end = text.find(lineBreak);
        }
        if (end == std::string_view::npos && text.size() >= base::BlockReader::kBlock)
            fail("a header line is longer than a megabyte");
        std::string line(text.substr(0, end));
        input_.consume(std::min(line.size() + 1, text.size()));
        ++line_;
        return line;
    }

    void readStatement(std::string_view keyword, const std::vector<std::string_view>& words,
                       std::string_view text) {
        if (keyword == "comment") return readComment(words, text);
        if (keyword == "obj_info") return;
        if (keyword == "format") return readFormat(words);
        if (keyword == "element") return readElement(words);
        if (keyword == "property") return readProperty(words);
        // Programs have written comments without their keyword; a misspelt keyword must not go unnoticed.
        if (const std::string nearest = base::didYouMean(keyword, kKeywords); !nearest.empty())
            fail(fmt::format("unknown keyword '{}' in the header{}", shown(words[0]), nearest));
        oddities_.add(Severity::Warning, "header lines that begin with no keyword of PLY; ignored", line_);
    }

    void readComment(const std::vector<std::string_view>& words, std::string_view text) {
        if (words.size() < 3 || base::lowerCase(words[1]) != "texturefile") return;
        const std::size_t begin = static_cast<std::size_t>(words[2].data() - text.data());
        const std::size_t end =
            static_cast<std::size_t>(words.back().data() - text.data()) + words.back().size();
        header_.textureFiles.emplace_back(text.substr(begin, end - begin));
    }

    void readFormat(const std::vector<std::string_view>& words) {
        if (format_) fail("a second line 'format'");
        const std::string name = words.size() > 1 ? base::lowerCase(words[1]) : "";
        const auto found = std::find(kFormatNames.begin(), kFormatNames.end(), name);
        if (found == kFormatNames.end())
            fail(fmt::format("unknown format '{}'{}; expected {}", shown(name),
                             base::didYouMean(name, kFormatNames), base::joinChoices(kFormatNames)));
        format_ = static_cast<PlyFormat>(found - kFormatNames.begin());
        if (words.size() != 3 || words[2] != "1.0")
            oddities_.add(Severity::Warning,
                          "the version of the format is not 1.0; the file is read as version 1.0", line_);
    }

    void readElement(const std::vector<std::string_view>& words) {
        if (words.size() != 3) fail("expected 'element NAME COUNT'");
        PlyElement element{base::lowerCase(words[1]), 0, {}, line_};
        const std::string_view count = words[2];
        const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (error != std::errc{} || stop != count.data() + count.size())
            fail(fmt::format("invalid number of elements '{}'", shown(count)));
        if (header_.find(element.name) < header_.elements.size())
            fail(fmt::format("a second element '{}'", shown(element.name)));
        header_.elements.push_back(std::move(element));
    }

    void readProperty(const std::vector<std::string_view>& words) {
        if (header_.elements.empty()) fail("a property before the first element");
        const bool isList = words.size() > 1 && base::lowerCase(words[1]) == "list";
        if (words.size() != (isList ? 5u : 3u))
            fail("expected 'property TYPE NAME' or 'property list COUNT_TYPE TYPE NAME'");
        PlyProperty property{base::lowerCase(words.back()), typeOf(words[words.size() - 2]), {}, line_};
        if (isList) property.countType = typeOf(words[2]);
        if (isList && !isInteger(*property.countType))
            fail(fmt::format("the length of a list cannot have the type '{}'; expected an integer type",
                             shown(words[2])));
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType typeOf(std::string_view word) const {
        const std::string name = base::lowerCase(word);
        std::vector<std::string_view> known;
        for (const TypeName& type : kTypeNames) {
            if (type.name == name) return type.type;
            known.push_back(type.name);
        }
        fail(fmt::format("unknown type '{}'{}; expected {}", shown(word), base::didYouMean(name, known),
                         base::joinChoices(known)));
    }

    const std::string& path_;
    base::BlockReader& input_;
    Oddities& oddities_;
    PlyHeader header_{};
    std::optional<PlyFormat> format_;
    bool endsWithCr_ = false;
    int line_ = 0;
};

}  // namespace

std::size_t PlyElement::smallestRow() const {
    return std::accumulate(properties.begin(), properties.end(), std::size_t{0},
                           [](std::size_t sum, const PlyProperty& property) {
                               return sum + sizeOf(property.countType.value_or(property.type));
                           });
}

bool PlyElement::hasLists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.countType.has_value(); });
}

std::size_t PlyHeader::find(std::string_view name) const {
    const auto found =
        std::find_if(elements.begin(), elements.end(), [&](const PlyElement& e) { return e.name == name; });
    return static_cast<std::size_t>(found - elements.begin());
}

PlyHeader readPlyHeader(const std::string& path, base::BlockReader& input, Oddities& oddities) {
    return HeaderReader(path, input, oddities).read();
}

}  // namespace rayscope::scene
