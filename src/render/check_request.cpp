#include "render/check_request.h"

#include "base/check_argument.h"
#include "scene/check_description.h"

namespace rayscope::render {

void checkRequest(const RenderRequest& request) {
    using base::checkArgument;
    checkArgument(request.scene != nullptr, "request: scene is null");
    const long long pixels = static_cast<long long>(request.width) * request.height;
    checkArgument(request.width > 0 && request.height > 0 && pixels <= kMaxImagePixels,
                  "request: image of {} x {} pixels; expected 1 … {} pixels", request.width, request.height,
                  kMaxImagePixels);
    if (request.region) {
        const PixelBounds& region = *request.region;
        checkArgument(
            region.x0 >= 0 && region.x0 < region.x1 && region.x1 <= request.width && region.y0 >= 0 &&
                region.y0 < region.y1 && region.y1 <= request.height,
            "request: region of columns {} … {} and rows {} … {} is empty or outside the image of {} x {} "
            "pixels",
            region.x0, region.x1, region.y0, region.y1, request.width, request.height);
    }
    checkSettings(request.settings);
    scene::checkReferences(*request.scene);
}

}  // namespace rayscope::render
