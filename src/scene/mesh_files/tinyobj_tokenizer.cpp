#include "scene/mesh_files/tinyobj_tokenizer.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <streambuf>

namespace rayscope::scene {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The part of a line after its keyword, without the blanks around it.
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

/// Whether the line is a vertex, face, comment or blank, which tinyobjloader reports or may skip. `line`
/// starts with its first character that is no blank.
bool isCommonStatement(std::string_view line) {
    switch (line.front()) {
        case 'v': {
            const std::size_t at = line.size() > 1 && (line[1] == 'n' || line[1] == 't') ? 2 : 1;
            return at < line.size() && (line[at] == ' ' || line[at] == '\t');
        }
        case 'f':
            return line.size() > 1 && (line[1] == ' ' || line[1] == '\t');
        case '#':
        case '\r':
        case '\n':
            return true;
        default:
            return false;
    }
}

/// Holds one line of the text at a time, after joining continued lines and blanking comments in place.
class LineBuffer : public std::streambuf {
  public:
    /// `onOtherStatement` is called for each line that is not a common statement, before it is read.
    using Listener = std::function<void(std::string_view line)>;
    LineBuffer(std::string& text, Listener onOtherStatement)
        : text_(text),
          onOtherStatement_(std::move(onOtherStatement)),
          next_(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0) {}

    int line() const { return line_; }  ///< of the first of continued lines; counts from 1
    std::string_view current() const { return current_; }

  protected:
    int_type underflow() override {
        if (next_ >= text_.size()) return traits_type::eof();
        const std::size_t begin = next_;
        const std::size_t first = std::min(text_.find_first_not_of(" \t", begin), text_.size() - 1);
        const bool isComment = text_[first] == '#';
        line_ = nextLine_;
        next_ = joinContinuedLines(begin, isComment);
        current_ = std::string_view(text_).substr(begin, next_ - begin);
        const std::string_view statement = current_.substr(std::min(first, next_) - begin);
        if (!statement.empty() && !isCommonStatement(statement))
            onOtherStatement_(statement);
        else if (!isComment)
            blankTrailingComment(begin);
        setg(text_.data() + begin, text_.data() + begin, text_.data() + next_);
        return traits_type::to_int_type(text_[begin]);
    }

  private:
    /// Replaces backslashes before line ends, and these line ends, by blanks. Returns the end of the joined
    /// line.
    std::size_t joinContinuedLines(std::size_t begin, bool isComment) {
        for (std::size_t end = begin;;) {
            end = text_.find('\n', end);
            if (end == std::string::npos) return text_.size();
            ++nextLine_;
            const std::size_t last = end > begin && text_[end - 1] == '\r' ? end - 1 : end;
            if (isComment || last == begin || text_[last - 1] != '\\') return end + 1;
            std::fill(text_.begin() + static_cast<std::ptrdiff_t>(last - 1),
                      text_.begin() + static_cast<std::ptrdiff_t>(end + 1), ' ');
        }
    }

    void blankTrailingComment(std::size_t begin) {
        const std::size_t hash = current_.find('#');
        if (hash == std::string_view::npos) return;
        const std::size_t end = current_.find_last_not_of("\r\n") + 1;
        std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin + hash),
                  text_.begin() + static_cast<std::ptrdiff_t>(begin + end), ' ');
    }

    std::string& text_;
    Listener onOtherStatement_;
    std::size_t next_;
    int line_ = 0, nextLine_ = 1;
    std::string_view current_;
};

/// Whether tinyobjloader reads the line correctly: at least `count` words of digits, signs, points and
/// exponents.
bool hasPlainNumbers(std::string_view line, int count) {
    int words = 0;
    bool isInWord = false;
    for (const char c : line) {
        const bool isBlank = c == ' ' || c == '\t';
        if (!isBlank && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.' && c != 'e' && c != 'E')
            return false;
        words += !isBlank && !isInWord;
        isInWord = !isBlank;
    }
    return words >= count;
}

/// Receives the callbacks of tinyobjloader and passes them on with their lines.
class ObjTokenizer {
  public:
    ObjTokenizer(const std::string& path, std::string text, const ObjCallbacks& callbacks)
        : path_(path),
          text_(std::move(text)),
          lines_(text_, [this](std::string_view line) { onOtherStatement(line); }),
          callbacks_(callbacks) {}

    void run() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float x, float y, float z, float) {
            of(self).callbacks_.position(of(self).corrected({x, y, z}, 3), of(self).lines_.line());
        };
        callbacks.texcoord_cb = [](void* self, float x, float y, float) {
            of(self).callbacks_.texCoord(of(self).corrected({x, y, 0.0f}, 1), of(self).lines_.line());
        };
        callbacks.normal_cb = [](void* self, float x, float y, float z) {
            of(self).callbacks_.normal(of(self).corrected({x, y, z}, 3), of(self).lines_.line());
        };
        callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            of(self).onFace({indices, static_cast<std::size_t>(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char*, int) {
            of(self).callbacks_.useMaterial(argumentOf(of(self).lines_.current()), of(self).lines_.line());
        };
        std::istream stream(&lines_);
        stream.imbue(std::locale::classic());
        tinyobj::LoadObjWithCallback(stream, callbacks, this);
    }

  private:
    static ObjTokenizer& of(void* self) { return *static_cast<ObjTokenizer*>(self); }

    [[noreturn]] void fail(std::string message) const {
        throw InputError(std::move(message), {path_, lines_.line(), 0});
    }

    /// The value of the current line, with `count` required numbers, parsed again: NaN and infinity are kept,
    /// missing numbers and words are errors.
    glm::vec3 corrected(glm::vec3 value, int count) const {
        const std::string_view line = argumentOf(lines_.current());
        if (hasPlainNumbers(line, count)) return value;
        const char* at = line.data();
        const char* const end = at + line.size();
        for (int i = 0; i < 3; ++i) {
            while (at != end && (*at == ' ' || *at == '\t')) ++at;
            if (at == end) {
                if (i < count) fail(fmt::format("expected {} numbers, got {}", count, i));
                return value;
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
        return value;
    }

    void onFace(std::span<const tinyobj::index_t> indices) {
        if (indices.size() >= 3) checkDigits(argumentOf(lines_.current()));
        corners_.clear();
        for (const tinyobj::index_t& index : indices)
            corners_.push_back({index.vertex_index, index.texcoord_index, index.normal_index});
        callbacks_.face(corners_, lines_.line());
    }

    void checkDigits(std::string_view line) const {
        std::size_t digits = 0;
        for (const char c : line) {
            digits = c >= '0' && c <= '9' ? digits + 1 : 0;
            if (digits > std::numeric_limits<int>::digits10) fail("an index has more than nine digits");
        }
    }

    void onOtherStatement(std::string_view line) const {
        const std::string_view keyword = line.substr(0, line.find_first_of(" \t\r\n"));
        if (keyword == "mtllib")
            callbacks_.materialLibrary(argumentOf(line), lines_.line());
        else if (keyword != "usemtl" && keyword != "o" && keyword != "g" && keyword != "s")
            callbacks_.unknown(keyword, lines_.line());
    }

    const std::string& path_;
    std::string text_;
    LineBuffer lines_;
    const ObjCallbacks& callbacks_;
    std::vector<ObjIndices> corners_;
};

/// Finds what tinyobjloader skips silently: unknown statements, and a Tr that contradicts d.
void findSkippedStatements(const std::string& text, MtlContent& content) {
    static const std::set<std::string> kKnown{"newmtl", "Kd", "Ks", "Ns", "d", "Tr", "illum", "map_Kd"};
    std::istringstream lines(text);
    std::string line, material;
    std::optional<float> d, tr;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::string keyword;
        if (!(words >> keyword) || keyword.front() == '#') continue;
        if (!kKnown.contains(keyword)) content.ignored.insert(keyword);
        if (keyword == "newmtl") {
            words >> material;
            d = tr = {};
        }
        float value = 0.0f;
        if ((keyword != "d" && keyword != "Tr") || !(words >> value)) continue;
        (keyword == "d" ? d : tr) = value;
        if (d && tr && *d != 1.0f - *tr) content.opacityConflicts.push_back({material, *d, *tr, number});
    }
}

MtlMaterial convert(const tinyobj::material_t& material) {
    const auto color = [](const tinyobj::real_t(&c)[3]) {
        return Rgb(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]));
    };
    return {.name = material.name,
            .kd = color(material.diffuse),
            .ks = color(material.specular),
            .shininess = static_cast<float>(material.shininess),
            .opacity = static_cast<float>(material.dissolve),
            .illum = material.illum,
            .kdTexture = material.diffuse_texname,
            .clampsTexture = material.diffuse_texopt.clamp};
}

}  // namespace

void tokenizeObj(const std::string& path, std::string text, const ObjCallbacks& callbacks) {
    ObjTokenizer(path, std::move(text), callbacks).run();
}

MtlContent tokenizeMtl(const std::string& path, std::string text) {
    if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
    MtlContent content;
    findSkippedStatements(text, content);
    std::istringstream stream(text);
    std::map<std::string, int> names;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&names, &materials, &stream, &warning, &error);
    if (!error.empty()) throw InputError(error, {path});
    for (const tinyobj::material_t& material : materials) {
        if (material.name.empty()) continue;  // statements before the first newmtl
        content.materials.push_back(convert(material));
        const tinyobj::texture_option_t& options = material.diffuse_texopt;
        for (int axis = 0; axis < 2; ++axis)
            if (!material.diffuse_texname.empty() &&
                (options.origin_offset[axis] != 0 || options.scale[axis] != 1))
                content.ignored.insert("map_Kd -o/-s");
    }
    return content;
}

}  // namespace rayscope::scene
