#pragma once
// EXR files in memory, written with OpenEXR.
#include <ImfHeader.h>
#include <ImfPixelType.h>

#include <functional>
#include <string>
#include <vector>

#include "image/codecs/codecs.h"

namespace rayscope::test {

/// The value of a channel at a pixel of the data window.
using ExrPixels = std::function<float(const std::string& channel, int x, int y)>;

struct ExrWriter {
    ExrWriter(int width, int height) : header(width, height) {}
    ExrWriter(const Imath::Box2i& display, const Imath::Box2i& data) : header(display, data) {}

    std::string scanLines(const ExrPixels& pixels);
    std::string tiles(const ExrPixels& pixels);  ///< all levels hold the first pixels of the image

    Imf::Header header;
    Imf::PixelType type = Imf::HALF;
    float scale = 1.0f;  ///< of the values
    std::vector<std::string> channels{"R", "G", "B"};
};

/// Parts named part0, part1 … with the given channels.
std::string exrOfParts(const std::vector<std::vector<std::string>>& channels, int width, int height,
                       const ExrPixels& pixels);

/// A deep image with one sample per pixel.
std::string deepExr(int width, int height);

}  // namespace rayscope::test
