#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <new>
#include <span>
#include <vector>

#include "image/codecs/codecs.h"
#include "image/codecs/embedded_metadata.h"
#include "image/codecs/palette_lookup.h"
#include "image/codecs/png_calls.h"
#include "image/codecs/png_header.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

/// How the samples of a row become pixels.
struct RowFormat {
    int channels = 0;
    bool sixteenBits = false, indexed = false;
    const float* linear = nullptr;     ///< the linear value of each code
    PaletteLookup* palette = nullptr;  ///< if the samples are indices

    void convert(const png_byte* row, Rgb* pixels, int width) const {
        for (int x = 0; x < width; ++x) pixels[x] = indexed ? palette->colorOf(row[x]) : colorAt(row, x);
    }

  private:
    float sampleAt(const png_byte* row, int at) const {
        return linear[sixteenBits ? row[2 * at] << 8 | row[2 * at + 1] : row[at]];
    }
    Rgb colorAt(const png_byte* row, int x) const {
        const int at = x * channels;
        if (channels < 3) return Rgb(sampleAt(row, at));
        return Rgb(sampleAt(row, at), sampleAt(row, at + 1), sampleAt(row, at + 2));
    }
};

/// libpng for one file. Each member function is one stage: it returns, or throws InputError.
class PngReader {
  public:
    explicit PngReader(const ImageFile& file) : file_(file), position_(0) {
        png_ = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &messages_, onPngError, onPngWarning,
                                        &messages_, allocateForPng, freeForPng);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, [](png_structp png, png_bytep data, png_size_t size) {
            static_cast<PngReader*>(png_get_io_ptr(png))->read(data, size);
        });
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    void readInfo() {
        run([this] {
            // The size has been checked; chunks that are not needed must not cost memory.
            png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
            static constexpr png_byte kUnused[] = "tEXt\0zTXt\0iTXt\0hIST\0sPLT\0eXIf\0tIME";
            png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kUnused, sizeof kUnused / 5);
            png_read_info(png_, info_);
            if (png_get_bit_depth(png_, info_) < 8) {
                if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE)
                    png_set_packing(png_);
                else
                    png_set_expand_gray_1_2_4_to_8(png_);
            }
            passes_ = png_set_interlace_handling(png_);
            png_read_update_info(png_, info_);
        });
    }

    RgbImage readPixels() {
        RgbImage image(static_cast<int>(png_get_image_width(png_, info_)),
                       static_cast<int>(png_get_image_height(png_, info_)));
        const std::vector<float> linear = transferTable();
        const std::vector<Rgb> colors = palette(linear);
        PaletteLookup lookup(colors);
        const RowFormat format{.channels = png_get_channels(png_, info_),
                               .sixteenBits = png_get_bit_depth(png_, info_) == 16,
                               .indexed = png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE,
                               .linear = linear.data(),
                               .palette = &lookup};
        const std::size_t rowSize = png_get_rowbytes(png_, info_);
        // Interlaced rows are complete after the last pass only.
        std::vector<png_byte> rows(passes_ > 1 ? rowSize * static_cast<std::size_t>(image.height) : rowSize);
        run([&, this] {
            for (int pass = 1; pass <= passes_; ++pass)
                for (int y = 0; y < image.height; ++y) {
                    png_byte* row = rows.data() + (passes_ > 1 ? rowSize * static_cast<std::size_t>(y) : 0);
                    png_read_row(png_, row, nullptr);
                    if (pass == passes_) format.convert(row, &image.at(0, y), image.width);
                }
            png_read_end(png_, nullptr);
        });
        lookup.report(file_);
        return image;
    }

    /// Reports what has been ignored.
    void reportNotes() const {
        png_charp name;
        int compression;
        png_bytep profile;
        png_uint_32 size;
        if (png_get_iCCP(png_, info_, &name, &compression, &profile, &size) && !isSrgb())
            noteIccProfile(file_, std::as_bytes(std::span(profile, size)));
        if (!isSrgb() && hasOtherPrimaries())
            file_.note("the primaries of the image (cHRM) are ignored: the colours are read as sRGB");
        if (messages_.warnings > 1)
            file_.warn(fmt::format("{} oddities of the file are ignored, first: {}", messages_.warnings,
                                   messages_.warning));
        else if (messages_.warnings == 1)
            file_.warn(fmt::format("an oddity of the file is ignored: {}", messages_.warning));
    }

  private:
    template <class Calls>
    void run(Calls calls) {
        if (runPngCalls(png_, calls)) return;
        if (messages_.outOfMemory) throw std::bad_alloc();
        file_.damaged(messages_.error);
    }

    void read(png_bytep data, png_size_t size) {
        if (size > file_.bytes.size() - position_) png_error(png_, kEndsTooEarly);
        std::memcpy(data, file_.bytes.data() + position_, size);
        position_ += size;
    }

    bool isSrgb() const { return png_get_valid(png_, info_, PNG_INFO_sRGB) != 0; }

    bool hasOtherPrimaries() const {
        png_fixed_point chromaticity[8];
        if (!png_get_cHRM_fixed(png_, info_, &chromaticity[0], &chromaticity[1], &chromaticity[2],
                                &chromaticity[3], &chromaticity[4], &chromaticity[5], &chromaticity[6],
                                &chromaticity[7]))
            return false;
        constexpr png_fixed_point kSrgb[]{31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
        constexpr png_fixed_point kTolerance = 500;
        for (int i = 0; i < 8; ++i)
            if (std::abs(chromaticity[i] - kSrgb[i]) > kTolerance) return true;
        return false;
    }

    /// The linear value of each code of 8 or 16 bits. The gamma 45455 is the one that files in sRGB should
    /// name for programs that do not know sRGB.
    std::vector<float> transferTable() const {
        const std::uint32_t maximum = png_get_bit_depth(png_, info_) == 16 ? 65535 : 255;
        png_fixed_point gamma;
        constexpr png_fixed_point kOfSrgb = 45455, kTolerance = 100;
        if (isSrgb() || !png_get_gAMA_fixed(png_, info_, &gamma) || std::abs(gamma - kOfSrgb) <= kTolerance)
            return srgbTable(maximum);
        const double exponent = PNG_FP_1 / static_cast<double>(gamma);
        std::vector<float> linear(maximum + 1);
        for (std::size_t code = 0; code < linear.size(); ++code)
            linear[code] = static_cast<float>(std::pow(static_cast<double>(code) / maximum, exponent));
        file_.note(fmt::format("decoded with the exponent {:.4g} of the file (gAMA), not with the sRGB curve",
                               exponent));
        return linear;
    }

    std::vector<Rgb> palette(const std::vector<float>& linear) const {
        png_colorp colors = nullptr;
        int count = 0;
        std::vector<Rgb> palette;
        if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE &&
            png_get_PLTE(png_, info_, &colors, &count))
            for (const png_color& color : std::span(colors, static_cast<std::size_t>(count)))
                palette.push_back(Rgb(linear[color.red], linear[color.green], linear[color.blue]));
        return palette;
    }

    const ImageFile& file_;
    std::size_t position_;
    PngMessages messages_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    int passes_ = 1;
};

}  // namespace

RgbImage decodePng(const ImageFile& file) {
    checkPngHeader(file);
    PngReader reader(file);
    reader.readInfo();
    RgbImage image = reader.readPixels();
    reader.reportNotes();
    return image;
}

}  // namespace rayscope::image
