#include "cli/error_map_file.h"

#include <rayscope/compare.h>

#include "post/display_transform.h"

namespace rayscope::cli {

void writeErrorMap(const std::string& path, const Image<double>& map, double range) {
    RgbImage picture = applyColorMap(map, range);
    if (!post::isDisplayFormat(path))
        for (std::size_t i = 0; i < map.pixels.size(); ++i)
            picture.pixels[i] = Rgb(static_cast<float>(map.pixels[i]));
    writeImage(path, picture);
}

}  // namespace rayscope::cli
