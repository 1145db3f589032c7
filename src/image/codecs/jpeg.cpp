#include <fmt/format.h>

// jpeglib.h needs the types of the next two headers.
#include <cstddef>
#include <cstdio>

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <new>
#include <vector>

#include "image/codecs/codecs.h"
#include "image/codecs/jpeg_markers.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

/// What libjpeg reports. Its error handler is the first member, so that callbacks find the rest.
struct Messages {
    jpeg_error_mgr handler;
    std::jmp_buf onError;
    char error[JMSG_LENGTH_MAX];   ///< of the call that failed
    char damage[JMSG_LENGTH_MAX];  ///< the first warning that says that pixels are missing or wrong
    char oddity[JMSG_LENGTH_MAX];  ///< the first warning that does not concern pixels
    bool outOfMemory, unsupported, missesEndMarker;
};

Messages& messagesOf(j_common_ptr jpeg) { return *reinterpret_cast<Messages*>(jpeg->err); }

[[noreturn]] void onError(j_common_ptr jpeg) {
    Messages& messages = messagesOf(jpeg);
    const int code = jpeg->err->msg_code;
    messages.outOfMemory = code == JERR_OUT_OF_MEMORY;
    messages.unsupported = code == JERR_ARITH_NOTIMPL || code == JERR_FRACT_SAMPLE_NOTIMPL ||
                           code == JERR_CCIR601_NOTIMPL || code == JERR_CONVERSION_NOTIMPL ||
                           code == JERR_NOTIMPL;
    jpeg->err->format_message(jpeg, messages.error);
    std::longjmp(messages.onError, 1);
}

void onMessage(j_common_ptr jpeg, int level) {
    if (level >= 0) return;  // traces
    Messages& messages = messagesOf(jpeg);
    ++jpeg->err->num_warnings;
    switch (jpeg->err->msg_code) {
        case JWRN_JPEG_EOF:
            messages.missesEndMarker = true;
            break;
        case JWRN_EXTRANEOUS_DATA:
        case JWRN_JFIF_MAJOR:
        case JWRN_ADOBE_XFORM:
        case JWRN_TOO_MUCH_DATA:
            if (!messages.oddity[0]) jpeg->err->format_message(jpeg, messages.oddity);
            break;
        default:
            if (!messages.damage[0]) jpeg->err->format_message(jpeg, messages.damage);
    }
}

/// How four components become a colour. Adobe stores the inks inverted.
struct InkFormat {
    bool inverted;

    Rgb colorOf(const JSAMPLE* inks) const {
        const auto channel = [&](int i) {
            const int paper = inverted ? inks[i] : 255 - inks[i], light = inverted ? inks[3] : 255 - inks[3];
            return decodeByte(static_cast<std::uint8_t>((paper * light + 127) / 255));
        };
        return Rgb(channel(0), channel(1), channel(2));
    }
};

void convert(const jpeg_decompress_struct& jpeg, const JSAMPLE* row, Rgb* pixels) {
    const InkFormat inks{jpeg.saw_Adobe_marker != FALSE};
    for (JDIMENSION x = 0; x < jpeg.output_width; ++x) {
        const JSAMPLE* samples = row + x * static_cast<JDIMENSION>(jpeg.output_components);
        if (jpeg.output_components == 1)
            pixels[x] = Rgb(decodeByte(samples[0]));
        else if (jpeg.output_components == 3)
            pixels[x] = Rgb(decodeByte(samples[0]), decodeByte(samples[1]), decodeByte(samples[2]));
        else
            pixels[x] = inks.colorOf(samples);
    }
}

/// Decodes into `image`; false after an error, which libjpeg reports by a jump into this function. Therefore
/// no object here has a destructor.
bool decodeInto(RgbImage& image, FileBytes file, jpeg_decompress_struct& jpeg, Messages& messages,
                JSAMPLE* row, std::size_t rowSize) {
    if (setjmp(messages.onError) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(file.data()),
                 static_cast<unsigned long>(file.size()));
    jpeg_read_header(&jpeg, TRUE);
    if (jpeg.num_components == 4) jpeg.out_color_space = JCS_CMYK;
    jpeg.dct_method = JDCT_ISLOW;
    jpeg.do_block_smoothing = FALSE;
    jpeg_start_decompress(&jpeg);
    if (jpeg.output_width != static_cast<JDIMENSION>(image.width) ||
        jpeg.output_height != static_cast<JDIMENSION>(image.height) ||
        rowSize < jpeg.output_width * static_cast<std::size_t>(jpeg.output_components))
        ERREXIT(&jpeg, JERR_BAD_LENGTH);
    while (jpeg.output_scanline < jpeg.output_height) {
        const int y = static_cast<int>(jpeg.output_scanline);
        if (jpeg_read_scanlines(&jpeg, &row, 1) == 1) convert(jpeg, row, &image.at(0, y));
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

void report(const ImageFile& file, const jpeg_decompress_struct& jpeg, const Messages& messages) {
    if (messages.damage[0]) file.damaged(messages.damage);
    if (messages.missesEndMarker) file.warn("the end marker of the JPEG image is missing");
    if (messages.oddity[0]) file.warn(fmt::format("an oddity of the file is ignored: {}", messages.oddity));
    if (jpeg.num_components == 4) file.note("its CMYK colours are converted to RGB without a colour profile");
}

}  // namespace

RgbImage decodeJpeg(const ImageFile& file) {
    const JpegLayout layout = checkJpegMarkers(file);
    RgbImage image(layout.width, layout.height);
    std::vector<JSAMPLE> row(4 * static_cast<std::size_t>(layout.width));
    Messages messages{};
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&messages.handler);
    messages.handler.error_exit = onError;
    messages.handler.emit_message = onMessage;
    const bool complete = decodeInto(image, file.bytes, jpeg, messages, row.data(), row.size());
    jpeg_destroy_decompress(&jpeg);
    if (messages.outOfMemory) throw std::bad_alloc();
    if (messages.unsupported)
        file.refuse(fmt::format("is a JPEG image with a feature that is not read ({}); convert it to PNG",
                                messages.error));
    if (!complete) file.damaged(messages.error);
    report(file, jpeg, messages);
    return image;
}

}  // namespace rayscope::image
