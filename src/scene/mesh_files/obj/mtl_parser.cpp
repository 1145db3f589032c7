#include "scene/mesh_files/obj/mtl_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/lower_case.h"
#include "base/parse_float.h"
#include "scene/mesh_files/obj/skipped_statements.h"
#include "scene/mesh_files/text/text_lines.h"

namespace rayscope::scene {

namespace {

/// Linear sRGB of a colour in CIE XYZ with the white point D65 (IEC 61966-2-1).
Rgb xyzToRgb(const Rgb& xyz) {
    return {3.2406f * xyz.x - 1.5372f * xyz.y - 0.4986f * xyz.z,
            -0.9689f * xyz.x + 1.8758f * xyz.y + 0.0415f * xyz.z,
            0.0557f * xyz.x - 0.2040f * xyz.y + 1.0570f * xyz.z};
}

class MtlParser {
  public:
    MtlParser(const std::string& path, std::string_view text, Oddities& oddities)
        : lines_(path, text), oddities_(oddities) {}

    std::vector<ParsedMaterial> parse() {
        while (lines_.next()) {
            Words words(lines_.line());
            const std::string_view keyword = words.next();
            if (keyword.starts_with('#')) continue;
            parseStatement(keyword, trimmed(words.rest()));
        }
        if (materials_.empty())
            warn("is not an MTL file: it has no newmtl statement", 0);
        else
            skipped_.report("MTL", oddities_);
        return std::move(materials_);
    }

  private:
    using Handler = void (MtlParser::*)(std::string_view keyword, std::string_view arguments);
    struct Statement {
        std::string_view keyword;
        Handler handler;
    };

    void parseStatement(std::string_view keyword, std::string_view arguments) {
        static constexpr std::array kStatements{
            Statement{"newmtl", &MtlParser::beginMaterial}, Statement{"Kd", &MtlParser::setColor},
            Statement{"Ks", &MtlParser::setColor},          Statement{"Ns", &MtlParser::setShininess},
            Statement{"d", &MtlParser::setOpacity},         Statement{"Tr", &MtlParser::setOpacity},
            Statement{"illum", &MtlParser::setIllum},       Statement{"map_Kd", &MtlParser::setTexture}};
        const std::string lower = base::lowerCase(keyword);
        const auto found = std::find_if(kStatements.begin(), kStatements.end(), [&](const Statement& known) {
            return base::lowerCase(known.keyword) == lower;
        });
        if (found == kStatements.end()) return skipped_.add(keyword, lines_.number());
        if (found->keyword != keyword)
            oddities_.add(Severity::Note, "keywords in another case than in the specification; read",
                          lines_.number());
        if (materials_.empty() && found->handler != &MtlParser::beginMaterial)
            return warn("statements before the first newmtl; ignored");
        (this->*found->handler)(found->keyword, arguments);
    }

    void warn(std::string_view kind) { warn(kind, lines_.number()); }
    void warn(std::string_view kind, int line) { oddities_.add(Severity::Warning, kind, line); }

    ParsedMaterial& current() { return materials_[current_]; }

    void beginMaterial(std::string_view, std::string_view name) {
        const auto [found, isNew] = byName_.try_emplace(std::string(name), materials_.size());
        current_ = found->second;
        if (isNew)
            materials_.push_back({.name = std::string(name), .line = lines_.number()});
        else
            warn("materials with the name of an earlier one; the later statements replace the earlier ones");
    }

    /// The numbers at the beginning of the arguments. Nothing, with a warning, if there are none or the first
    /// word is no number, or if one is not finite.
    std::vector<float> numbers(std::string_view keyword, std::string_view arguments) {
        std::vector<float> list;
        Words words(arguments);
        for (std::string_view word = words.next(); !word.empty() && word.front() != '#';
             word = words.next()) {
            const std::optional<float> value = parseNumber(word);
            if (!value && list.empty()) {
                warn(fmt::format("{} with a word instead of a number; ignored", keyword));
                return {};
            }
            if (!value) {
                warn(fmt::format("{} with words behind its numbers; these are ignored", keyword));
                break;
            }
            list.push_back(*value);
        }
        if (list.empty()) warn(fmt::format("{} without a number; ignored", keyword));
        if (!std::all_of(list.begin(), list.end(), [](float value) { return std::isfinite(value); })) {
            warn(fmt::format("{} with NaN, infinity or a number beyond the range of floats; ignored",
                             keyword));
            return {};
        }
        return list;
    }

    /// Also with a comma as decimal separator, and with a comment behind it.
    std::optional<float> parseNumber(std::string_view word) {
        if (const std::optional<float> value = base::parseFloat(word)) return value;
        word = word.substr(0, word.find('#'));
        if (std::count(word.begin(), word.end(), ',') != 1) return base::parseFloat(word);
        std::string withPoint(word);
        *std::find(withPoint.begin(), withPoint.end(), ',') = '.';
        const std::optional<float> value = base::parseFloat(withPoint);
        if (value) warn("numbers with a decimal comma; read as a point");
        return value;
    }

    std::optional<float> number(std::string_view keyword, std::string_view arguments) {
        const std::vector<float> list = numbers(keyword, arguments);
        if (list.empty()) return {};
        if (list.size() > 1) warnExtra(keyword);
        return list.front();
    }
    void warnExtra(std::string_view keyword) {
        warn(fmt::format("{} with too many numbers; the last ones are ignored", keyword));
    }

    float clamped(std::string_view keyword, float value, float upper) {
        if (value < 0.0f) warn(fmt::format("{} below 0; 0 is used", keyword));
        if (value > upper) warn(fmt::format("{} above {}; {} is used", keyword, upper, upper));
        return std::clamp(value, 0.0f, upper);
    }

    /// K? r [g b] | K? xyz x [y z] | K? spectral file [factor]. One number stands for all three.
    void setColor(std::string_view keyword, std::string_view arguments) {
        Words words(arguments);
        const std::string_view first = words.next();
        if (first == "spectral")
            return warn(fmt::format("{} with a spectral curve, which is not read; ignored", keyword));
        const bool isXyz = first == "xyz";
        std::vector<float> list = numbers(keyword, isXyz ? words.rest() : arguments);
        if (list.empty()) return;
        if (list.size() == 1) list.resize(3, list.front());
        if (list.size() == 2)
            return warn(fmt::format("{} with two numbers instead of one or three; ignored", keyword));
        if (list.size() > 3) warnExtra(keyword);
        Rgb color(list[0], list[1], list[2]);
        if (isXyz) {
            oddities_.add(Severity::Note, fmt::format("{} xyz; converted to sRGB", keyword), lines_.number());
            color = xyzToRgb(color);
        }
        for (int i = 0; i < 3; ++i) color[i] = clamped(keyword, color[i], 1.0f);
        (keyword == "Kd" ? current().statements.kd : current().statements.ks) = color;
    }

    void setShininess(std::string_view keyword, std::string_view arguments) {
        if (const std::optional<float> value = number(keyword, arguments))
            current().statements.ns = clamped(keyword, *value, std::numeric_limits<float>::max());
    }

    void setOpacity(std::string_view keyword, std::string_view arguments) {
        Words words(arguments);
        if (words.next() == "-halo") {
            oddities_.add(Severity::Note, "d -halo; read as d", lines_.number());
            arguments = words.rest();
        }
        const std::optional<float> value = number(keyword, arguments);
        if (!value) return;
        MtlStatements& statements = current().statements;
        (keyword == "d" ? statements.d : statements.tr) = clamped(keyword, *value, 1.0f);
        current().opacityLine = lines_.number();
        // Programs write these with three digits or more.
        if (statements.d && statements.tr && std::abs(*statements.d - (1.0f - *statements.tr)) > 5e-4f)
            oddities_.add(Severity::Note, "d and Tr that contradict each other; d is used", lines_.number());
    }

    void setIllum(std::string_view keyword, std::string_view arguments) {
        const std::optional<float> value = number(keyword, arguments);
        if (!value) return;
        if (*value < 0.0f || *value > 10.0f || *value != std::floor(*value))
            return warn("illum is not an integer from 0 to 10; ignored");
        current().statements.illum = static_cast<int>(*value);
    }

    void setTexture(std::string_view keyword, std::string_view arguments) {
        const TextureArguments texture = parseTexture(arguments);
        if (texture.file.empty()) return warn(fmt::format("{} without a file name; ignored", keyword));
        if (texture.isIncomplete) warn(fmt::format("options of {} without their values; ignored", keyword));
        if (texture.isMoved)
            warn(fmt::format("{} with scale or offset (-s, -o, -t), which are ignored", keyword));
        if (!texture.ignored.empty())
            warn(fmt::format("ignored options of {}: {}", keyword, fmt::join(texture.ignored, ", ")));
        current().texture = texture.file;
        current().clampsTexture = texture.clamps;
        current().textureLine = lines_.number();
    }

    TextLines lines_;
    Oddities& oddities_;
    SkippedStatements skipped_;
    std::vector<ParsedMaterial> materials_;
    std::map<std::string, std::size_t, std::less<>> byName_;
    std::size_t current_ = 0;
};

}  // namespace

std::vector<ParsedMaterial> parseMtl(const std::string& path, std::string_view text, Oddities& oddities) {
    return MtlParser(path, text, oddities).parse();
}

}  // namespace rayscope::scene
