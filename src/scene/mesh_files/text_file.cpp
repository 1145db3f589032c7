#include "scene/mesh_files/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "scene/mesh_files/text_encoding.h"
#include "scene/mesh_files/text_lines.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// Files by their first bytes.
struct Magic {
    std::string_view bytes;
    std::string_view format;  ///< as in the argument of readTextFile(); empty: none that is read
    std::string_view what;    ///< behind "this is "
    std::string_view advice;
};

using namespace std::string_view_literals;
constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kRename = "rename the file accordingly";
constexpr std::string_view kConvert = "convert it to OBJ";

constexpr std::array kMagics{
    Magic{"\x1f\x8b"sv, "", "a gzip archive", kUnpack},
    Magic{"PK\x03\x04"sv, "", "a zip archive", kUnpack},
    Magic{"\x28\xb5\x2f\xfd"sv, "", "a zstd archive", kUnpack},
    Magic{"\xfd"
          "7zXZ"sv,
          "", "an xz archive", kUnpack},
    Magic{"BZh"sv, "", "a bzip2 archive", kUnpack},
    Magic{"7z\xbc\xaf"sv, "", "a 7z archive", kUnpack},
    Magic{"Rar!"sv, "", "a RAR archive", kUnpack},
    Magic{"version https://git-lfs"sv, "", "a Git LFS pointer, not the file itself", "run 'git lfs pull'"},
    Magic{"ply\n"sv, "PLY", "a PLY file", kRename},
    Magic{"ply\r"sv, "PLY", "a PLY file", kRename},
    Magic{"glTF"sv, "glTF", "a binary glTF file", "name it .glb"},
    Magic{"Kaydara FBX"sv, "", "an FBX file", kConvert},
    Magic{"; FBX"sv, "", "an FBX file", kConvert},
    Magic{"BLENDER"sv, "", "a Blender file", "export it as OBJ"},
    Magic{"OFF\n"sv, "", "an OFF file", kConvert},
    Magic{"#VRML"sv, "", "a VRML file", kConvert},
    Magic{"xof 0"sv, "", "a DirectX mesh", kConvert},
    Magic{"\x64\x86"sv, "", "an object file of a compiler (machine code)", "choose a mesh file"},
    Magic{"\x4c\x01"sv, "", "an object file of a compiler (machine code)", "choose a mesh file"},
    Magic{"\x7f"
          "ELF"sv,
          "", "an ELF file (machine code)", "choose a mesh file"},
    Magic{"\x89PNG"sv, "", "a PNG image", "choose a mesh file"},
    Magic{"\xff\xd8\xff"sv, "", "a JPEG image", "choose a mesh file"},
    Magic{"%PDF"sv, "", "a PDF document", "choose a mesh file"},
};

bool startsWithIgnoringCase(std::string_view text, std::string_view lowerCasePrefix) {
    return text.size() >= lowerCasePrefix.size() &&
           std::equal(lowerCasePrefix.begin(), lowerCasePrefix.end(), text.begin(), [](char a, char b) {
               return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b);
           });
}

[[noreturn]] void refuse(const std::string& path, std::string_view format, std::string_view what,
                         std::string_view advice) {
    throw InputError(
        fmt::format("is not {} {} file: this is {}; {}", format == "PLY" ? "a" : "an", format, what, advice),
        {path});
}

/// Refuses text of other formats that have no fixed first bytes.
void refuseOtherText(const std::string& path, std::string_view format, std::string_view text) {
    const std::size_t first = text.substr(0, 4096).find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return;
    const std::string_view begin = text.substr(first, 4096);
    if (startsWithIgnoringCase(begin, "<!doctype html") || startsWithIgnoringCase(begin, "<html"))
        refuse(path, format, "a web page", "download the file itself");
    if (begin.front() == '<') refuse(path, format, "XML", kConvert);
    if (begin.front() == '{' && format != "glTF")
        refuse(path, format, begin.find("\"asset\"") != std::string_view::npos ? "a glTF file" : "JSON",
               kRename);
    if (format != "STL" && begin.starts_with("solid") && begin.find("facet") != std::string_view::npos)
        refuse(path, format, "an STL file", kRename);
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

void refuseOtherFormats(const std::string& path, std::string_view format, std::string_view bytes) {
    for (const Magic& magic : kMagics)
        if (bytes.starts_with(magic.bytes) && magic.format != format)
            refuse(path, format, magic.what, magic.advice);
}

std::string readTextFile(const std::string& path, std::string_view format, Oddities& oddities) {
    refuseSpecialFile(path);
    std::string text = readSource(path);
    if (const std::optional<ByteOrder> order = utf16Order(text)) {
        text = utf16ToUtf8(text, *order);
        oddities.add(Severity::Note, "the text is UTF-16");
    } else {
        refuseOtherFormats(path, format, text);
        if (looksBinary(text)) refuse(path, format, "binary data, not text", "export it as text");
        if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
        if (!isUtf8(text)) {
            text = windows1252ToUtf8(text);
            oddities.add(Severity::Note, "bytes that are not UTF-8; read as Windows-1252 (Latin-1)");
        }
    }
    refuseOtherText(path, format, text);
    replaceLoneReturns(text);
    replaceZeros(text, oddities);
    return text;
}

}  // namespace rayscope::scene
