#include "scene/mesh_files/text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "scene/mesh_files/text/foreign_format.h"
#include "scene/mesh_files/text/text_encoding.h"
#include "scene/mesh_files/text/text_lines.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// What the file is if it is not text of this format; empty if it may be. Beside first bytes that are fixed,
/// it knows the beginnings of web pages, XML and JSON with blanks before them.
std::string_view foreignText(std::string_view text, std::string_view format) {
    const std::size_t first = text.substr(0, 4096).find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    const std::string_view begin = text.substr(first, 4096);
    if (const std::string_view meaning = foreignFormat(begin, format); !meaning.empty()) return meaning;
    if (begin.front() == '<') return "is XML or a web page";
    if (begin.front() == '{')
        return begin.find("\"asset\"") != std::string_view::npos ? "is a glTF file; rename it to .gltf"
                                                                 : "is JSON";
    return {};
}

/// Whether more than one in 32 of the first bytes are control characters other than blanks.
bool looksBinary(std::string_view bytes) {
    const std::string_view begin = bytes.substr(0, 4096);
    const auto controls = std::count_if(begin.begin(), begin.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\n' && !isBlank(c);
    });
    return static_cast<std::size_t>(controls) * 32 > begin.size();
}

/// Replaces each CR that is not followed by LF.
void replaceLoneReturns(std::string& text) {
    char* const end = text.data() + text.size();
    for (char* at = text.data(); at != end; ++at) {
        at = static_cast<char*>(std::memchr(at, '\r', static_cast<std::size_t>(end - at)));
        if (!at) return;
        if (at + 1 == end || at[1] != '\n') *at = '\n';
    }
}

void replaceZeros(std::string& text, Oddities& oddities) {
    if (text.find('\0') == std::string::npos) return;
    oddities.add(Severity::Warning, "zero bytes in the text; read as blanks");
    std::replace(text.begin(), text.end(), '\0', ' ');
}

}  // namespace

std::string readTextFile(const std::string& path, std::string_view format, Oddities& oddities,
                         const LoadControl& control) {
    refuseSpecialFile(path);
    const auto refuse = [&](std::string_view meaning) {
        throw InputError(fmt::format("not a file in {} format: it {}", format, meaning), {path});
    };
    std::string text = readSource(path, control);
    if (isUtf32(text)) refuse(foreignFormat(text, format));
    if (const std::optional<ByteOrder> order = utf16Order(text)) {
        text = utf16ToUtf8(text, *order);
        oddities.add(Severity::Note, "the text is UTF-16");
    }
    if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
    if (const std::string_view meaning = foreignText(text, format); !meaning.empty()) refuse(meaning);
    if (looksBinary(text)) refuse("is binary, not text");
    if (!isUtf8(text)) {
        text = windows1252ToUtf8(text);
        oddities.add(Severity::Note, "bytes that are not UTF-8; read as Windows-1252 (Latin-1)");
    }
    replaceLoneReturns(text);
    replaceZeros(text, oddities);
    return text;
}

}  // namespace rayscope::scene
