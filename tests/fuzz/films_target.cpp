#include <rayscope/diagnostics.h>

#include "fuzz/memory_file.h"
#include "measure/trade/film_file.h"

namespace rayscope::test {

/// Any bytes fill two films of the expected size, or none, or are refused with the reason.
bool fuzzFilms(FuzzInput input) {
    static const MemoryFile file("films");
    constexpr PixelBounds kWhole{0, 4, 0, 3};
    render::Film a(4, 3, kWhole), b(4, 3, kWhole);
    bool isLoaded = false;
    try {
        isLoaded = measure::loadFilms(file.write(input), "hash", a, b);
    } catch (const InputError&) {
    }
    require(isLoaded || (a.completeSamples() == 0 && b.completeSamples() == 0), "refused films stay empty");
    return true;
}

}  // namespace rayscope::test
