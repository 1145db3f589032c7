#include "image/codecs/format.h"

#include <fmt/format.h>

#include "image/codecs/codecs.h"

namespace rayscope::image {

namespace {

using namespace std::string_view_literals;

bool isSpaceOrRemark(char c) { return " \t\r\n\v\f#"sv.find(c) != std::string_view::npos; }

/// A letter of `kinds` behind the 'P', then white space: the start of PNM and PFM files.
bool looksLikePortable(std::string_view text, std::string_view kinds) {
    if (text.size() < 3 || text[0] != 'P' || kinds.find(text[1]) == std::string_view::npos) return false;
    return isSpaceOrRemark(text[2]) ||
           (text.starts_with("PF4") && text.size() > 3 && isSpaceOrRemark(text[3]));
}

struct Signature {
    std::size_t offset;
    std::string_view bytes, name;
    std::string_view advice = "; convert it to PNG or EXR";
};

constexpr std::string_view kUnpack = ", not an image; unpack it first";
constexpr std::string_view kDownload = ", not an image; download the image itself";

constexpr Signature kForeign[]{
    {0, "GIF8"sv, "a GIF image"},
    {0, "8BPS"sv, "a Photoshop document"},
    {0, "\x53\x80\xf6\x34"sv, "a Softimage PIC image"},
    {8, "WEBP"sv, "a WebP image"},
    {0, "II*\0"sv, "a TIFF image"},
    {0, "MM\0*"sv, "a TIFF image"},
    {0, "II+\0"sv, "a TIFF image"},
    {0, "MM\0+"sv, "a TIFF image"},
    {0, "II\xbc\x01"sv, "a JPEG XR image"},
    {4, "ftypavif"sv, "an AVIF image"},
    {4, "ftypavis"sv, "an AVIF image"},
    {4, "ftyphei"sv, "a HEIC image"},
    {4, "ftyphev"sv, "a HEIC image"},
    {4, "ftypmif1"sv, "a HEIF image"},
    {4, "ftypmsf1"sv, "a HEIF image"},
    {4, "ftyp"sv, "a video"},
    {0, "\xff\x0a"sv, "a JPEG XL image"},
    {0, "\0\0\0\x0cJXL "sv, "a JPEG XL image"},
    {0, "\0\0\0\x0cjP  "sv, "a JPEG 2000 image"},
    {0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 image"},
    {0, "DDS "sv, "a DDS texture"},
    {1, "KTX 11"sv, "a KTX texture"},
    {1, "KTX 20"sv, "a KTX texture"},
    {0, "qoif"sv, "a QOI image"},
    {0, "farbfeld"sv, "a farbfeld image"},
    {0, "BA"sv, "an OS/2 bitmap array"},
    {0, "\x8aMNG\r\n\x1a\n"sv, "an MNG animation"},
    {0, "\x8bJNG\r\n\x1a\n"sv, "a JNG image"},
    {0, "gimp xcf"sv, "a GIMP document"},
    {0, "\x01\xda"sv, "an SGI image"},
    {0, "\x59\xa6\x6a\x95"sv, "a Sun raster image"},
    {0, "SDPX"sv, "a DPX image"},
    {0, "XPDS"sv, "a DPX image"},
    {0, "\x80\x2a\x5f\xd7"sv, "a Cineon image"},
    {0, "BPG\xfb"sv, "a BPG image"},
    {0, "FLIF"sv, "a FLIF image"},
    {0, "SIMPLE  ="sv, "a FITS image"},
    {0, "/* XPM */"sv, "an XPM image"},
    {0, "#define "sv, "an XBM image"},
    {0, "\x0a\x05\x01"sv, "a PCX image"},
    {8, "ILBM"sv, "an ILBM image"},
    {0, "P7 332"sv, "an XV thumbnail"},
    {0, "<svg"sv, "an SVG drawing"},
    {0, "<?xml"sv, "an XML document or SVG drawing"},
    {0, "%PDF"sv, "a PDF document"},
    {0, "%!PS"sv, "a PostScript document"},
    {0, "BLENDER"sv, "a Blender document"},
    {0, "\x1f\x8b"sv, "a gzip archive", kUnpack},
    {0, "PK\x03\x04"sv, "a ZIP archive", kUnpack},
    {0, "BZh"sv, "a bzip2 archive", kUnpack},
    {0,
     "\xfd"
     "7zXZ"sv,
     "an xz archive", kUnpack},
    {0, "\x28\xb5\x2f\xfd"sv, "a Zstandard archive", kUnpack},
    {0, "7z\xbc\xaf"sv, "a 7-Zip archive", kUnpack},
    {0, "Rar!"sv, "a RAR archive", kUnpack},
    {0, "<!DOCTYPE html"sv, "a web page", kDownload},
    {0, "<!doctype html"sv, "a web page", kDownload},
    {0, "<html"sv, "a web page", kDownload},
    {0, "version https://git-lfs"sv, "a Git LFS pointer", ", not an image; fetch it with 'git lfs pull'"},
};

bool matches(FileBytes file, const Signature& signature) {
    return file.size() >= signature.offset &&
           textOf(file.subspan(signature.offset)).starts_with(signature.bytes);
}

/// Icons and cursors start like TGA files without a colour map, but with a count of images.
bool looksLikeIcon(FileBytes file) {
    const std::string_view text = textOf(file);
    return file.size() > 5 && (text.starts_with("\0\0\1\0"sv) || text.starts_with("\0\0\2\0"sv)) &&
           text[4] != 0 && text[5] == 0;
}

}  // namespace

std::string describeForeignFormat(FileBytes file) {
    if (looksLikeIcon(file)) return "is an icon or cursor; convert it to PNG or EXR";
    for (const Signature& signature : kForeign)
        if (matches(file, signature)) return fmt::format("is {}{}", signature.name, signature.advice);
    return {};
}

std::optional<Format> detectFormat(FileBytes file) {
    const std::string_view text = textOf(file);
    if (text.starts_with("\x89PNG")) return Format::Png;
    if (text.starts_with("\xff\xd8\xff")) return Format::Jpeg;
    if (text.starts_with("BM")) return Format::Bmp;
    if (text.starts_with("#?")) return Format::Hdr;
    if (text.starts_with("\x76\x2f\x31\x01")) return Format::Exr;
    if (looksLikePortable(text, "Ff")) return Format::Pfm;
    if (looksLikePortable(text, "123456")) return Format::Pnm;
    if (text.starts_with("P7\n") || text.starts_with("P7\r")) return Format::Pnm;
    if (tgaProblem(file).empty()) return Format::Tga;
    return std::nullopt;
}

}  // namespace rayscope::image
