#include <algorithm>
#include <cstdint>
#include <new>
#include <stop_token>
#include <vector>

#include "image/codecs/codecs.h"
#include "image/codecs/png_calls.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

/// A text chunk: tEXt, which all programs read, for ASCII; iTXt for other UTF-8. The result refers to its
/// arguments.
png_text textChunk(std::string& keyword, const std::string& text) {
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
    png_text chunk{};
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = keyword.data();
    chunk.text = const_cast<char*>(text.c_str());  // which libpng does not change
    (ascii ? chunk.text_length : chunk.itxt_length) = text.size();
    return chunk;
}

void append(png_structp png, png_bytep data, png_size_t size) {
    try {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
        return;
    } catch (const std::bad_alloc&) {
        static_cast<PngMessages*>(png_get_mem_ptr(png))->outOfMemory = true;
    }
    png_error(png, "out of memory");
}

/// libpng for one file.
class PngWriter {
  public:
    PngWriter() {
        png_ = png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &messages_, onPngError, onPngWarning,
                                         &messages_, allocateForPng, freeForPng);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) {
            png_destroy_write_struct(&png_, nullptr);
            throw std::bad_alloc();
        }
        png_set_write_fn(png_, &bytes_, append, [](png_structp) {});
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

    /// Empty if a stop is requested before the last row.
    std::string write(const RgbImage& image, const std::vector<png_text>& texts, Encoding encoding,
                      bool isCompressed, const std::stop_token& stop) {
        std::vector<png_byte> row(3 * static_cast<std::size_t>(image.width));
        bool isStopped = false;
        const std::size_t pixelBytes = row.size() * static_cast<std::size_t>(image.height);
        if (!isCompressed) bytes_.reserve(pixelBytes + pixelBytes / 64);
        auto calls = [&, this] {
            if (!isCompressed) {
                png_set_compression_level(png_, 0);
                png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
                png_set_compression_buffer_size(png_, std::size_t{1} << 20);  // of an IDAT chunk
            }
            png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
            png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width),
                         static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                         PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
            if (encoding == Encoding::Srgb) png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
            if (!texts.empty()) png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
            png_write_info(png_, info_);
            for (int y = 0; y < image.height; ++y) {
                isStopped = stop.stop_requested();
                if (isStopped) return;
                png_byte* next = row.data();
                for (int x = 0; x < image.width; ++x)
                    for (int c = 0; c < 3; ++c) *next++ = encodeByte(image.at(x, y)[c], encoding);
                png_write_row(png_, row.data());
            }
            png_write_end(png_, info_);
        };
        if (runPngCalls(png_, calls)) return isStopped ? std::string() : std::move(bytes_);
        if (messages_.outOfMemory) throw std::bad_alloc();
        throw InputError(messages_.error);
    }

  private:
    PngMessages messages_;
    std::string bytes_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace

std::string encodePng(const RgbImage& image, const ImageMetadata& metadata, Encoding encoding,
                      const std::stop_token& compressing) {
    constexpr std::size_t kMaxKeywordLength = 79;
    std::vector<std::string> keywords;
    for (const auto& [key, value] : metadata)
        keywords.push_back(metadataName(key).substr(0, kMaxKeywordLength));
    std::vector<png_text> texts;
    for (const auto& [key, value] : metadata) texts.push_back(textChunk(keywords[texts.size()], value));
    std::string file = PngWriter().write(image, texts, encoding, true, compressing);
    return file.empty() ? PngWriter().write(image, texts, encoding, false, {}) : file;
}

}  // namespace rayscope::image
