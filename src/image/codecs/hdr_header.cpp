#include "image/codecs/hdr_header.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace rayscope::image {

namespace {

constexpr std::string_view kHdrSpaces = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(kHdrSpaces), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(kHdrSpaces) + 1);
}

/// Removes the next word from the front of `text`.
std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(kHdrSpaces), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(kHdrSpaces));
    text.remove_prefix(word.size());
    return word;
}

/// `count` positive finite numbers and nothing else.
template <std::size_t count>
std::optional<std::array<double, count>> positiveNumbers(std::string_view text) {
    std::array<double, count> numbers{};
    for (double& number : numbers) {
        std::string_view word = takeWord(text);
        if (word.starts_with('+')) word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
        if (!(number > 0.0) || !std::isfinite(number)) return std::nullopt;
    }
    if (!takeWord(text).empty()) return std::nullopt;
    return numbers;
}

/// Whether the text consists of numbers that differ from the given ones by at most `tolerance`.
template <std::size_t count>
bool areNear(std::string_view text, const std::array<double, count>& expected, double tolerance) {
    const auto numbers = positiveNumbers<count>(text);
    for (std::size_t i = 0; numbers && i < count; ++i)
        if (std::abs((*numbers)[i] - expected[i]) > tolerance) return false;
    return numbers.has_value();
}

class HdrHeaderReader {
  public:
    explicit HdrHeaderReader(const ImageFile& file)
        : file_(file), text_(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()) {}

    HdrHeader read() {
        takeLine();  // the signature
        for (std::string_view line = takeLine(); !line.empty(); line = takeLine()) readVariable(line);
        readResolution(takeLine());
        for (int c = 0; c < 3; ++c)
            header_.factor[c] = static_cast<float>(1.0 / divisor_[static_cast<std::size_t>(c)]);
        reportApplied();
        header_.pixels = at_;
        return header_;
    }

  private:
    std::string_view takeLine() {
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos) file_.damaged("unexpected end of the header");
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        return line.substr(0, line.find_last_not_of(kHdrSpaces) + 1);
    }

    void readVariable(std::string_view line) {
        const std::size_t equals = line.find('=');
        // Programs indent the headers of the pictures that they combined.
        const bool indented = line.starts_with(' ') || line.starts_with('\t');
        if (indented || line.starts_with('#') || equals == std::string_view::npos) return;
        const std::string_view name = trimmed(line.substr(0, equals)),
                               value = trimmed(line.substr(equals + 1));
        if (name == "FORMAT") {
            readFormat(value);
        } else if (name == "EXPOSURE") {
            if (const auto exposure = positiveNumbers<1>(value)) {
                for (double& divisor : divisor_) divisor *= exposure->front();
                exposed_ = true;
            } else {
                ignore(name, value);
            }
        } else if (name == "COLORCORR") {
            if (const auto correction = positiveNumbers<3>(value)) {
                for (std::size_t c = 0; c < 3; ++c) divisor_[c] *= (*correction)[c];
                exposed_ = true;
            } else {
                ignore(name, value);
            }
        } else if (name == "PIXASPECT" || name == "GAMMA") {
            if (!areNear<1>(value, {1.0}, 1e-3)) ignore(name, value);
        } else if (name == "PRIMARIES") {
            // Those of sRGB; those of Radiance, which files without primaries have, differ by up to 0.021.
            if (!areNear<8>(value, {0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329}, 0.025))
                ignore(name, value);
        }
    }

    void readFormat(std::string_view value) {
        header_.xyz = value == "32-bit_rle_xyze";
        if (!header_.xyz && value != "32-bit_rle_rgbe")
            file_.refuse(fmt::format(
                "is a Radiance picture with FORMAT={}; expected 32-bit_rle_rgbe or 32-bit_rle_xyze",
                cut(value)));
    }

    static std::string_view cut(std::string_view value) { return value.substr(0, 60); }

    void ignore(std::string_view name, std::string_view value) {
        file_.warn(fmt::format("{}={} is ignored", name, cut(value)));
    }

    /// "-Y 480 +X 640": the first axis counts scan lines, the second pixels along one.
    void readResolution(std::string_view line) {
        const std::string_view major = takeWord(line), majorSize = takeWord(line);
        const std::string_view minor = takeWord(line), minorSize = takeWord(line);
        const auto isAxis = [](std::string_view word, char letter) {
            return word.size() == 2 && (word[0] == '+' || word[0] == '-') && word[1] == letter;
        };
        header_.columns = isAxis(major, 'X');
        const std::string_view x = header_.columns ? major : minor, y = header_.columns ? minor : major;
        if (!isAxis(x, 'X') || !isAxis(y, 'Y') || !takeWord(line).empty())
            file_.damaged("expected a size such as -Y 480 +X 640");
        header_.rightToLeft = x[0] == '-';
        header_.bottomToTop = y[0] == '+';
        header_.width = size(header_.columns ? majorSize : minorSize);
        header_.height = size(header_.columns ? minorSize : majorSize);
        checkImageSize(header_.width, header_.height, file_.bytes.size(), file_.name);
    }

    int size(std::string_view word) const {
        int number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc{} || end != word.data() + word.size())
            file_.damaged("expected a size such as -Y 480 +X 640");
        return number;
    }

    void reportApplied() {
        for (const double divisor : divisor_)
            if (!std::isnormal(static_cast<float>(1.0 / divisor)))
                file_.damaged("EXPOSURE and COLORCORR are out of range");
        if (exposed_)
            file_.note(fmt::format(
                "EXPOSURE and COLORCORR are undone: the pixels are divided by {:.6g} {:.6g} {:.6g}",
                divisor_[0], divisor_[1], divisor_[2]));
        if (header_.xyz)
            file_.note("its CIE XYZ colours are converted to linear sRGB; negative values become 0");
    }

    const ImageFile& file_;
    std::string_view text_;
    std::size_t at_ = 0;
    HdrHeader header_;
    std::array<double, 3> divisor_{1.0, 1.0, 1.0};
    bool exposed_ = false;
};

}  // namespace

HdrHeader readHdrHeader(const ImageFile& file) { return HdrHeaderReader(file).read(); }

}  // namespace rayscope::image
