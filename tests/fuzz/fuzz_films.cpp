#include <cstdint>

#include "fuzz/memory_file.h"
#include "measure/trade/film_file.h"

/// Any bytes fill two films of the expected size, are refused with an InputError, or none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const rayscope::test::MemoryFile file("films");
    rayscope::render::Film a(4, 3), b(4, 3);
    rayscope::measure::loadFilms(file.write(data, size), "hash", a, b);
    return 0;
}
