#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

#include "base/memory_budget.h"
#include "image/chromaticities.h"
#include "image/codecs/exr_picture.h"

namespace rayscope::image {

namespace {

class MemoryInput : public Imf::IStream {
  public:
    MemoryInput(FileBytes file, const std::string& name) : IStream(name.c_str()), file_(file) {}

    bool read(char data[], int size) override {
        const std::size_t count = static_cast<std::size_t>(size);
        if (position_ > file_.size() || count > file_.size() - position_)
            throw std::runtime_error("unexpected end of file");
        std::memcpy(data, file_.data() + position_, count);
        position_ += count;
        return position_ < file_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = static_cast<std::size_t>(position); }

  private:
    FileBytes file_;
    std::size_t position_ = 0;
};

/// The address of pixel (0, 0) of an image whose first pixel is (left, top). It may lie outside the
/// allocation; hence integer arithmetic instead of pointer arithmetic.
template <class Pixel>
std::intptr_t addressOfOrigin(Image<Pixel>& image, const ExrBox& window) {
    const std::intptr_t first = static_cast<std::intptr_t>(window.top) * image.width + window.left;
    return reinterpret_cast<std::intptr_t>(image.pixels.data()) -
           first * static_cast<std::intptr_t>(sizeof(Pixel));
}

/// Reads channels of any type as float; tiles, mipmaps and all line orders are the library's business.
void readChannels(MemoryInput& stream, const ExrPicture& picture, const ExrBox& window, RgbImage& image) {
    Imf::MultiPartInputFile input(stream);
    Imf::InputPart part(input, static_cast<int>(picture.part));
    const std::intptr_t origin = addressOfOrigin(image, window);
    const std::size_t rowSize = sizeof(Rgb) * static_cast<std::size_t>(image.width);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < (picture.isLuminance ? 1 : picture.channels.size()); ++i) {
        if (picture.channels[i].empty()) continue;
        char* base = reinterpret_cast<char*>(origin + static_cast<std::intptr_t>(i * sizeof(float)));
        buffer.insert(picture.channels[i], Imf::Slice(Imf::FLOAT, base, sizeof(Rgb), rowSize));
    }
    part.setFrameBuffer(buffer);
    part.readPixels(window.top, window.bottom);
    if (picture.isLuminance)
        for (Rgb& pixel : image.pixels) pixel = Rgb(pixel.x);
}

/// The library's conversion from luminance and chroma at half resolution.
void readLuminanceChroma(MemoryInput& stream, const ExrPicture& picture, const ExrBox& window,
                         RgbImage& image) {
    Imf::RgbaInputFile input(stream, picture.layer);
    Image<Imf::Rgba> pixels(image.width, image.height);
    auto* origin = reinterpret_cast<Imf::Rgba*>(addressOfOrigin(pixels, window));
    input.setFrameBuffer(origin, 1, static_cast<std::size_t>(image.width));
    input.readPixels(window.top, window.bottom);
    std::transform(pixels.pixels.begin(), pixels.pixels.end(), image.pixels.begin(),
                   [](const Imf::Rgba& p) { return Rgb(float{p.r}, float{p.g}, float{p.b}); });
}

/// The picture of the display window: black where the data window has no pixels.
RgbImage fitToDisplay(RgbImage&& data, const ExrBox& from, const ExrBox& to) {
    if (from == to) return std::move(data);
    RgbImage image(static_cast<int>(to.width()), static_cast<int>(to.height()));
    const int left = std::max(from.left, to.left), right = std::min(from.right, to.right);
    for (int y = std::max(from.top, to.top); left <= right && y <= std::min(from.bottom, to.bottom); ++y)
        std::copy_n(&data.at(left - from.left, y - from.top), right - left + 1,
                    &image.at(left - to.left, y - to.top));
    return image;
}

class Reader {
  public:
    Reader(FileBytes file, const std::string& name, Diagnostics* notes)
        : file_(file), name_(name), notes_(notes) {}

    RgbImage read() {
        const ExrFile headers = readExrHeaders(file_, name_);
        const ExrPicture picture = choosePicture(headers, name_, notes_);
        const ExrPart& part = headers.parts[picture.part];
        const ExrBox &data = part.dataWindow, &display = part.displayWindow;
        checkImageSize(data.width(), data.height(), file_.size(), name_);
        checkImageSize(display.width(), display.height(), file_.size(), name_);
        checkExrBlocks(file_, headers, picture.part, name_);

        RgbImage image(static_cast<int>(data.width()), static_cast<int>(data.height()));
        MemoryInput stream(file_, name_);
        if (picture.hasChroma)
            readLuminanceChroma(stream, picture, data, image);
        else
            readChannels(stream, picture, data, image);
        if (!picture.isLuminance || picture.hasChroma) convertPrimaries(part, image);
        noteOddities(part);
        return fitToDisplay(std::move(image), data, display);
    }

  private:
    void note(std::string message) const {
        if (notes_) notes_->push_back({Severity::Note, std::move(message), {name_}});
    }

    void convertPrimaries(const ExrPart& part, RgbImage& image) const {
        if (!part.chromaticities || isRec709(*part.chromaticities)) return;
        const std::optional<glm::dmat3> matrix = toRec709(*part.chromaticities);
        if (!matrix) return note("its chromaticities span no triangle and are ignored");
        for (Rgb& pixel : image.pixels) pixel = Rgb(*matrix * glm::dvec3(pixel));
        note("its colours have other primaries than sRGB and are converted");
    }

    void noteOddities(const ExrPart& part) const {
        const ExrBox &data = part.dataWindow, &display = part.displayWindow;
        if (data != display)
            note(fmt::format(
                "its data window, {} x {} pixels at ({}, {}), is not its display window, {} x {} at "
                "({}, {}): the display window is shown, black where it has no data",
                data.width(), data.height(), data.left, data.top, display.width(), display.height(),
                display.left, display.top));
        if (part.pixelAspectRatio.value_or(1.0f) != 1.0f)
            note(fmt::format("its pixels have an aspect ratio of {:g}; read as square",
                             *part.pixelAspectRatio));
        if (part.whiteLuminance)
            note(fmt::format("its white has a luminance of {:g} cd/m²; values are read without it",
                             *part.whiteLuminance));
    }

    FileBytes file_;
    const std::string& name_;
    Diagnostics* notes_;
};

}  // namespace

RgbImage decodeExr(FileBytes file, const std::string& name, Diagnostics* notes) {
    constexpr int kAttempts = 2;
    for (int attempt = 1;; ++attempt) {
        try {
            return Reader(file, name, notes).read();
        } catch (const InputError&) {
            throw;
        } catch (const std::exception& error) {
            if (base::reportsLackOfMemory(error)) throw std::bad_alloc();
            // Some errors of the library are the same for damage and for a lack of memory, such as zlib's.
            if (attempt == kAttempts) throwDamaged(name, error.what());
        }
    }
}

}  // namespace rayscope::image
