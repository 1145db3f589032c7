#pragma once
#include <rayscope/diagnostics.h>

#include "image/codecs/exr_file.h"

namespace rayscope::image {

/// What is read of an EXR file: the channels of one layer of one part.
struct ExrPicture {
    std::size_t part = 0;
    std::string layer;                    ///< name of the layer; "" for channels without one
    std::array<std::string, 3> channels;  ///< of red, green and blue; "" reads 0
    bool isLuminance = false;             ///< the three channels are the same Y
    bool hasChroma = false;               ///< RY and BY beside Y
};

/// Chooses the first part and layer with R, G or B, or else with Y; channels without a layer come first.
/// Adds notes about the choice. Throws InputError if there is none, with the channels that there are.
ExrPicture choosePicture(const ExrFile& headers, const std::string& name, Diagnostics* notes);

}  // namespace rayscope::image
