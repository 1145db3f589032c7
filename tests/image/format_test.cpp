#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include "image/test_images.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bytesOf;
using testing::AllOf;
using testing::HasSubstr;

TEST(Format, FormatsThatAreNotReadAreNamed) {
    const struct {
        std::string start;
        const char* name;
    } kFormats[]{
        {"GIF87a", "a GIF image"},
        {"GIF89a", "a GIF image"},
        {"8BPS\0\1"s, "a Photoshop document"},
        {"\x53\x80\xf6\x34", "a Softimage PIC image"},
        {"RIFF\x10\0\0\0WEBPVP8 "s, "a WebP image"},
        {"II*\0"s, "a TIFF image"},
        {"MM\0*"s, "a TIFF image"},
        {"II+\0"s, "a TIFF image"},
        {"\0\0\0\x1c"
         "ftypavif"s,
         "an AVIF image"},
        {"\0\0\0\x1c"
         "ftypheic"s,
         "a HEIC image"},
        {"\0\0\0\x1c"
         "ftypmp42"s,
         "a video"},
        {"\xff\x0a", "a JPEG XL image"},
        {"\0\0\0\x0cJXL \r\n\x87\n"s, "a JPEG XL image"},
        {"\0\0\0\x0cjP  \r\n\x87\n"s, "a JPEG 2000 image"},
        {"\xff\x4f\xff\x51", "a JPEG 2000 image"},
        {"DDS |\0\0\0"s, "a DDS texture"},
        {"\xabKTX 11\xbb\r\n\x1a\n", "a KTX texture"},
        {"\xabKTX 20\xbb\r\n\x1a\n", "a KTX texture"},
        {"qoif", "a QOI image"},
        {"\0\0\1\0\1\0"s, "an icon or cursor"},
        {"BA", "an OS/2 bitmap array"},
        {"\x8aMNG\r\n\x1a\n", "an MNG animation"},
        {"gimp xcf v011", "a GIMP document"},
        {"\x01\xda\1\1", "an SGI image"},
        {"\x0a\x05\x01\x08", "a PCX image"},
        {"FORM\0\0\0\0ILBM"s, "an ILBM image"},
        {"<svg xmlns", "an SVG drawing"},
        {"<?xml version", "an XML document or SVG drawing"},
        {"%PDF-1.7", "a PDF document"},
        {"\x1f\x8b\x08", "a gzip archive, not an image; unpack it first"},
        {"PK\x03\x04", "a ZIP archive, not an image; unpack it first"},
        {"<!DOCTYPE html>", "a web page, not an image; download the image itself"},
        {"version https://git-lfs.github.com/spec/v1\n", "'git lfs pull'"},
    };
    for (const auto& format : kFormats)
        for (const std::size_t padding : {0u, 300u})
            EXPECT_THAT(
                test::inputErrorOf([&] { test::decode(format.start + std::string(padding, '\0'), "x.png"); }),
                AllOf(HasSubstr("x.png: error: is "), HasSubstr(format.name)));
}

TEST(Format, OtherFilesAreNoImages) {
    for (const std::string& file : {"plain text\n"s, "P"s, "P8\n1 1\n"s, "PNG"s, "v 0 0 0\nf 1 1 1\n"s,
                                    std::string(100, '\0'), std::string(100, '\xff')})
        EXPECT_THAT(test::inputErrorOf([&] { test::decode(file, "x.png"); }),
                    HasSubstr("not an image; expected PNG, JPEG, BMP, TGA, HDR, EXR, PFM or PNM"));
}

TEST(Format, TheContentCountsAndNotTheSuffix) {
    EXPECT_EQ(test::decode("P5 1 1 255\n\xff", "x.png").at(0, 0), Rgb(1.0f));
}

}  // namespace
}  // namespace rayscope
