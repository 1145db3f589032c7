#include <rayscope/aov.h>
#include <algorithm>

#include "base/check_argument.h"
#include "render/film.h"

namespace rayscope {

std::vector<std::string_view> aovNames() {
    std::vector<std::string_view> names;
    for (const AovInfo& info : aovTable()) names.push_back(info.name);
    return names;
}

std::vector<RgbImage> renderAovs(const RenderedImage& image, std::span<const std::string> names,
                                 const AovOptions& options) {
    base::checkArgument(image.world != nullptr, "image: world is null");
    std::vector<Aov> aovs;
    for (const std::string& name : names) aovs.push_back(aovNamed(name));
    const int samples = image.film ? std::max(1, image.film->completeSamples()) : 1;
    const AovRequest request{*image.world,         image.film.get(), image.request.seed, samples,
                             image.request.region, options.threads,  options.stop};
    return renderAovs(request, aovs);
}

}  // namespace rayscope
