#pragma once
#include <optional>
#include <string>

#include "image/codecs/image_file.h"

namespace rayscope::image {

enum class Format { Png, Jpeg, Bmp, Tga, Hdr, Exr, Pfm, Pnm };

/// The format by the signature of the file, or nullopt. TGA has no signature: its whole header must be valid.
std::optional<Format> detectFormat(FileBytes file);

/// Why a file of a known format is not read, and what to do: "is a GIF image; convert it to PNG or EXR".
/// Empty if the format is unknown.
std::string describeForeignFormat(FileBytes file);

}  // namespace rayscope::image
