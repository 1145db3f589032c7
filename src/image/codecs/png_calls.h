#pragma once
// What reading and writing PNG with libpng share: its errors, without jumps over C++ objects.
#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <string>

namespace rayscope::image {

/// What libpng reports during its calls.
struct PngMessages {
    char error[128] = "";
    bool outOfMemory = false;
    std::string warning;  ///< the first one
    int warnings = 0;
};

/// The callbacks of png_create_read_struct_2() and png_create_write_struct_2(); their pointers refer to the
/// PngMessages.
[[noreturn]] void onPngError(png_structp png, png_const_charp message);
void onPngWarning(png_structp png, png_const_charp message);
png_voidp allocateForPng(png_structp png, png_alloc_size_t size);
void freeForPng(png_structp png, png_voidp memory);

/// Runs calls of libpng; false after an error, which libpng reports by a jump into this function. Therefore
/// `calls` must not create objects with destructors.
template <class Calls>
bool runPngCalls(png_structp png, Calls& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    calls();
    return true;
}

}  // namespace rayscope::image
