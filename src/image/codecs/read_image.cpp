#include <rayscope/diagnostics.h>

#include <filesystem>
#include <system_error>

#include "base/file_suffix.h"
#include "base/memory_budget.h"
#include "base/printable_text.h"
#include "base/read_file.h"
#include "image/codecs/codecs.h"
#include "image/codecs/format.h"

namespace rayscope {

namespace {

RgbImage decode(image::Format format, const image::ImageFile& file) {
    switch (format) {
        case image::Format::Png:
            return image::decodePng(file);
        case image::Format::Jpeg:
            return image::decodeJpeg(file);
        case image::Format::Bmp:
            return image::decodeBmp(file);
        case image::Format::Tga:
            return image::decodeTga(file);
        case image::Format::Hdr:
            return image::decodeHdr(file);
        case image::Format::Pfm:
            return image::decodePfm(file);
        case image::Format::Pnm:
            return image::decodePnm(file);
        case image::Format::Exr:
            break;
    }
    return image::decodeExr(file.bytes, file.name, file.notes);
}

}  // namespace

RgbImage readImage(const std::string& path, Diagnostics* notes) {
    std::error_code ignored;
    const auto type = std::filesystem::status(path, ignored).type();
    if (type == std::filesystem::file_type::character || type == std::filesystem::file_type::block)
        throw InputError("is a device, not a file", {path});  // it might not end
    const std::string file = base::readFile(path);
    return decodeImage(std::as_bytes(std::span(file)), path, notes);
}

RgbImage decodeImage(std::span<const std::byte> bytes, const std::string& name, Diagnostics* notes) {
    const image::ImageFile file{bytes, name, notes};
    if (bytes.empty()) file.refuse("empty image file (0 bytes); export it again");
    if (const auto format = image::detectFormat(bytes))
        return base::namingLackOfMemory("decoding " + base::printable(name), "a smaller image",
                                        [&] { return decode(*format, file); });
    if (const std::string known = image::describeForeignFormat(bytes); !known.empty()) file.refuse(known);
    if (base::hasSuffix(name, ".tga")) file.damaged(image::tgaProblem(bytes));
    file.refuse("not an image; expected PNG, JPEG, BMP, TGA, HDR, EXR, PFM or PNM");
}

}  // namespace rayscope
