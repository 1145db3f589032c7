// Renders a scene, writes images and an AOV, measures the noise and prints the ray tree of a pixel.
#include <rayscope/aov.h>
#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>
#include <rayscope/display.h>
#include <rayscope/open_request.h>
#include <rayscope/probe.h>
#include <rayscope/render_image.h>
#include <cstdio>

namespace {

rayscope::RenderedImage renderWith(rayscope::RenderRequest request, int samplesPerPixel) {
    request.settings.spp = samplesPerPixel;
    rayscope::RenderOptions options;
    options.progress = [](const rayscope::RenderStatus& status) {
        std::fprintf(stderr, "%3.0f %%\n", 100.0 * status.progress);
    };
    return rayscope::renderImage(request, options);
}

void run() {
    // The scene with its own settings and camera, except for what is set here.
    rayscope::RequestOverrides overrides;
    overrides.width = 160;
    overrides.height = 120;
    overrides.settings = {{"max_depth", "4", {}}};
    rayscope::Diagnostics notes;
    const rayscope::RenderRequest request = rayscope::openRequest("builtin:cornell-area", overrides, notes);

    // The file format decides whether the display transform is applied.
    const rayscope::RenderedImage image = renderWith(request, 16);
    const rayscope::ImageMetadata metadata = rayscope::metadataOf(request, image.status.samples);
    for (const char* path : {"cornell.png", "cornell.exr"})
        rayscope::writeRenderedImage(path, image.mean, request.settings, metadata);
    const std::vector<std::string> aovs{"depth"};
    rayscope::writeImage("cornell.depth.exr", rayscope::renderAovs(image, aovs).front());

    // The error of one sample per pixel, with the image above as the reference.
    const rayscope::RenderedImage noisy = renderWith(request, 1);
    const rayscope::ErrorMeasures errors = rayscope::measureErrors(noisy.mean, image.mean);
    std::printf("rmse %.4f, flip %.4f\n", errors.rmse, errors.flip);

    // The rays of sample 0 of the pixel in the middle.
    const rayscope::SampleId sample{request.width / 2, request.height / 2, 0};
    const rayscope::RayTree tree = rayscope::probeSample(*image.world, request.seed, sample);
    std::printf("%s", rayscope::toText(tree, *image.world).c_str());
}

}  // namespace

int main() try { run(); } catch (const rayscope::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
