#include <rayscope/image.h>

#include "base/memory_budget.h"

namespace rayscope {

void requireImageMemory(int width, int height, std::size_t bytesPerPixel) {
    base::requireMemory(
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * bytesPerPixel,
        "a smaller image (--size)", "an image of {} x {} pixels", width, height);
}

}  // namespace rayscope
