#include "scene/toml/parse.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <algorithm>
#include <filesystem>
#include <istream>
#include <utility>
#include <vector>

#include "scene/mesh_files/text/text_encoding.h"
#include "scene/progress_stream.h"
#include "scene/toml/values.h"

namespace rayscope::scene {

namespace {

/// Finds dotted keys, as in `a.b.c = 1`, that nest too deep, alone or in the inline tables of others. The
/// parser limits brackets, but not keys.
class DepthScan {
  public:
    DepthScan(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    void run() {
        while (at_ < text_.size()) step();
    }

  private:
    void step() {
        const char c = text_[at_];
        if (c == '"' || c == '\'') return skipString(c);
        if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
            return;
        }
        if (c == '\n') {
            ++line_;
            lineStart_ = at_ + 1;
        }
        count(c);
        if (ofOpenBrackets_ + dots_ > kMostLevels)
            throw InputError(fmt::format("a key with more than {} parts", kMostLevels),
                             {path_, line_, static_cast<int>(at_ - lineStart_) + 1});
        ++at_;
    }

    void count(char c) {
        if (c == '.') {
            ++dots_;
            return;
        }
        if (c == '=') ofKey_ = dots_;
        if (c == '[' || c == '{') {
            open_.push_back(ofKey_);
            ofOpenBrackets_ += ofKey_;
        }
        if ((c == ']' || c == '}') && !open_.empty()) {
            ofOpenBrackets_ -= open_.back();
            open_.pop_back();
        }
        if (c == '\n' || c == ',' || c == '[' || c == '{') ofKey_ = 0;
        if (c == '\n' || c == ',' || c == '[' || c == '{' || c == '=') dots_ = 0;
    }

    /// Moves behind a string of one line, or of several between three quotes.
    void skipString(char quote) {
        const std::string triple(3, quote);
        const bool longString = text_.substr(at_).starts_with(triple);
        at_ += longString ? 3 : 1;
        for (; at_ < text_.size(); ++at_) {
            if (longString ? text_.substr(at_).starts_with(triple) : text_[at_] == quote) {
                at_ += longString ? 3 : 1;
                return;
            }
            if (text_[at_] == '\n') {
                if (!longString) return;  // an error that the parser reports
                ++line_;
                lineStart_ = at_ + 1;
            }
            if (text_[at_] == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
        }
    }

    static constexpr int kMostLevels = 256;  // as many as the parser admits brackets
    const std::string& path_;
    std::string_view text_;
    std::size_t at_ = 0, lineStart_ = 0;
    int line_ = 1;
    int dots_ = 0;            ///< since the last separator
    int ofKey_ = 0;           ///< dots of the key before the last =
    std::vector<int> open_;   ///< dots of the keys of the open brackets
    int ofOpenBrackets_ = 0;  ///< their sum
};

/// Whether the last character of a UTF-8 text is incomplete.
bool endsWithinCharacter(std::string_view text) {
    for (std::size_t length = 1; length <= std::min<std::size_t>(3, text.size()); ++length) {
        const auto byte = static_cast<unsigned char>(text[text.size() - length]);
        if (byte < 0x80) return false;
        if (byte >= 0xc0) return length < (byte >= 0xf0 ? 4u : byte >= 0xe0 ? 3u : 2u);
    }
    return false;
}

/// What the file is instead of UTF-8 text with lines, and what to do; "" if it may be that.
std::string_view foreignText(std::string_view text) {
    if (isUtf32(text)) return "UTF-32 text; save it as UTF-8";
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "UTF-16 text; save it as UTF-8";
    if (text.starts_with("\x1f\x8b")) return "a gzip archive; unpack it first";
    if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
        return "the lines end with CR alone, as on old Macs; save it with LF";
    return {};
}

}  // namespace

toml::table parseToml(const std::string& path, std::string_view text, const LoadControl& control) {
    if (const std::string_view foreign = foreignText(text); !foreign.empty())
        throw InputError(std::string(foreign), {path});
    DepthScan(path, text).run();
    ProgressBuffer buffer(text, control, "parsing " + std::filesystem::path(path).filename().string());
    std::istream stream(&buffer);
    stream.exceptions(std::ios::badbit);
    try {
        // toml++ does not notice that a stream ends within a character.
        if (endsWithinCharacter(text)) return toml::parse(text, path);
        return toml::parse(stream, path);
    } catch (const toml::parse_error&) {
        buffer.rethrowFailure();
    }
    // The parser reads numbers with streams, which turn lack of memory into a wrong number: a wrong text is
    // wrong again.
    try {
        return toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        std::string message(error.description());
        if (message.find("invalid utf-8") != std::string::npos) message += "; save the file as UTF-8";
        throw InputError(std::move(message), positionIn(path, error.source()));
    }
}

}  // namespace rayscope::scene
