#include "image/codecs/png_calls.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace rayscope::image {

void onPngError(png_structp png, png_const_charp message) {
    auto* messages = static_cast<PngMessages*>(png_get_error_ptr(png));
    std::snprintf(messages->error, sizeof messages->error, "%s", message);
    png_longjmp(png, 1);
}

void onPngWarning(png_structp png, png_const_charp message) {
    auto* messages = static_cast<PngMessages*>(png_get_error_ptr(png));
    if (messages->warnings++ > 0) return;
    try {
        messages->warning = message;
    } catch (const std::bad_alloc&) {
        messages->warning.clear();
    }
}

png_voidp allocateForPng(png_structp png, png_alloc_size_t size) {
    void* memory = std::calloc(1, size);
    if (!memory) static_cast<PngMessages*>(png_get_mem_ptr(png))->outOfMemory = true;
    return memory;
}

void freeForPng(png_structp, png_voidp memory) { std::free(memory); }

}  // namespace rayscope::image
