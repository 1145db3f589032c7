#include "scene/mesh_files/text/foreign_format.h"

#include <fmt/format.h>

#include <array>

#include "scene/mesh_files/text/text_encoding.h"

namespace rayscope::scene {

namespace {

struct Magic {
    std::string_view bytes, meaning, format = {};
};
using namespace std::string_view_literals;
constexpr std::string_view kUtf16 = "is text in UTF-16; save it as UTF-8 or ASCII";
constexpr std::string_view kUtf32 = "is text in UTF-32; save it as UTF-8 or ASCII";
constexpr std::array kMagics{
    Magic{"\xff\xfe"sv, kUtf16},
    Magic{"\xfe\xff"sv, kUtf16},
    Magic{"\x1f\x8b"sv, "is compressed with gzip; decompress it first (gunzip)"},
    Magic{"BZh"sv, "is compressed with bzip2; decompress it first (bunzip2)"},
    Magic{"\xfd"
          "7zXZ"sv,
          "is compressed with xz; decompress it first (unxz)"},
    Magic{"\x28\xb5\x2f\xfd"sv, "is compressed with zstd; decompress it first (unzstd)"},
    Magic{"PK\x03\x04"sv, "is a ZIP archive; extract it first"},
    Magic{"7z\xbc\xaf\x27\x1c"sv, "is a 7z archive; extract it first"},
    Magic{"version https://git-lfs"sv, "is a pointer of Git LFS; fetch the file itself with git lfs pull"},
    Magic{"<!DOCTYPE html"sv, "is a web page"},
    Magic{"<!doctype html"sv, "is a web page"},
    Magic{"<html"sv, "is a web page"},
    Magic{"<?xml"sv, "is an XML file"},
    Magic{"glTF"sv, "is a binary glTF file; rename it to .glb"},
    Magic{"ply\n"sv, "is a PLY file; rename it to .ply", "PLY"},
    Magic{"ply\r"sv, "is a PLY file; rename it to .ply", "PLY"},
    Magic{"solid "sv, "is an STL file; rename it to .stl", "STL"},
    Magic{"Kaydara FBX"sv, "is an FBX file"},
    Magic{"BLENDER"sv, "is a Blender file"},
    Magic{"\x89PNG"sv, "is a PNG image"},
    Magic{"\xff\xd8\xff"sv, "is a JPEG image"},
    Magic{"%PDF"sv, "is a PDF document"},
    Magic{"Rar!"sv, "is a RAR archive; extract it first"},
    Magic{"; FBX"sv, "is an FBX file"},
    Magic{"OFF\n"sv, "is an OFF file"},
    Magic{"#VRML"sv, "is a VRML file"},
    Magic{"xof 0"sv, "is a DirectX mesh"},
    Magic{"\x64\x86"sv, "is an object file of a compiler (machine code)"},
    Magic{"\x4c\x01"sv, "is an object file of a compiler (machine code)"},
    Magic{"\x7f"
          "ELF"sv,
          "is an ELF file (machine code)"},
};

/// Latin text in UTF-16 without a byte order mark: every other byte is 0.
bool looksLikeUtf16(std::string_view start) {
    if (start.size() < 8) return false;
    for (const std::size_t zero : {0u, 1u}) {
        bool alternates = true;
        for (std::size_t i = 0; i < 8; ++i) alternates &= (start[i] == '\0') == (i % 2 == zero);
        if (alternates) return true;
    }
    return false;
}

}  // namespace

std::string_view foreignFormat(std::string_view start, std::string_view own) {
    if (isUtf32(start)) return kUtf32;
    if (looksLikeUtf16(start)) return kUtf16;
    for (const Magic& magic : kMagics)
        if (magic.format != own && start.starts_with(magic.bytes)) return magic.meaning;
    return {};
}

std::string describeForeign(std::string_view start, std::string_view own, std::string_view because) {
    if (start.empty()) return "the file is empty";
    const std::string_view meaning = foreignFormat(start, own);
    return fmt::format("not a file in {} format: it {}", own, meaning.empty() ? because : meaning);
}

}  // namespace rayscope::scene
