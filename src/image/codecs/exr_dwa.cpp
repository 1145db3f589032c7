// The head of a DWA block: sizes of its four streams, and rules that name the stream of each channel. OpenEXR
// takes both as they are, and leaves channels uninitialised that the sizes leave no bytes for.
#include <algorithm>
#include <cstring>

#include "image/codecs/exr_file.h"

namespace rayscope::image {

namespace {

/// Fields of the head, of 8 bytes each.
enum Field { kVersion, kUnknownSize, kRleSize = 7, kDcCount = 9, kFields = 11 };
enum Scheme { kUnknownScheme, kLossyScheme, kRleScheme };

struct Rule {
    std::string suffix;
    int scheme = kUnknownScheme, type = 0;
    bool ignoresCase = false;

    bool matches(std::string name, std::int32_t ofType) const {
        const std::size_t dot = name.rfind('.');
        if (dot != std::string::npos) name.erase(0, dot + 1);
        const auto same = [&](char a, char b) {
            const auto lower = [](char c) {
                return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            };
            return a == b || (ignoresCase && lower(a) == lower(b));
        };
        return type == ofType && std::equal(suffix.begin(), suffix.end(), name.begin(), name.end(), same);
    }
};

/// Reads the rules; false if they are cut off.
bool readRules(FileBytes bytes, std::vector<Rule>& rules) {
    std::uint16_t size = 0;  // with its own two bytes
    if (bytes.size() < sizeof size) return false;
    std::memcpy(&size, bytes.data(), sizeof size);
    if (size < sizeof size || size > bytes.size()) return false;
    std::size_t at = sizeof size;
    while (at < size) {
        Rule rule;
        while (at < size && bytes[at] != std::byte{0}) rule.suffix += static_cast<char>(bytes[at++]);
        if (size - at < 3) return false;
        const auto flags = static_cast<unsigned>(bytes[at + 1]);
        rule.scheme = static_cast<int>(flags >> 2 & 3);
        rule.ignoresCase = (flags & 1) != 0;
        rule.type = static_cast<int>(bytes[at + 2]);
        at += 3;
        rules.push_back(std::move(rule));
    }
    return true;
}

}  // namespace

bool fillsWithDwa(FileBytes packed, const ExrPart& part, const ExrBox& box) {
    std::array<std::uint64_t, kFields> head{};
    std::vector<Rule> rules;
    if (packed.size() < sizeof head) return false;
    std::memcpy(head.data(), packed.data(), sizeof head);
    // Version 2 is the first that was released.
    if (head[kVersion] != 2 || !readRules(packed.subspan(sizeof head), rules)) return false;
    std::uint64_t unknown = 0, runs = 0, dcCount = 0;
    for (const ExrChannel& channel : part.channels) {
        int scheme = kUnknownScheme;
        for (const Rule& rule : rules)
            if (rule.matches(channel.name, channel.type)) scheme = rule.scheme;
        const ExrSamples samples = samplesOf(channel, box);
        const auto size = static_cast<std::uint64_t>(samples.columns * samples.rows * sampleSize(channel));
        if (scheme == kUnknownScheme) unknown += size;
        if (scheme == kRleScheme) runs += size;
        if (scheme == kLossyScheme)
            dcCount += static_cast<std::uint64_t>(((samples.columns + 7) / 8) * ((samples.rows + 7) / 8));
    }
    return head[kUnknownSize] == unknown && head[kRleSize] == runs && head[kDcCount] == dcCount;
}

}  // namespace rayscope::image
