#include "picture_truth.h"

#include <gtest/gtest.h>
#include <rayscope/display.h>
#include <rayscope/render_image.h>

#include <map>

#include "probe/pixel_samples.h"
#include "support/run_program.h"

namespace rayscope::viewer {

namespace {

/// The texts of the tEXt chunks of a PNG file.
std::map<std::string, std::string> pngTexts(const std::string& file) {
    std::map<std::string, std::string> texts;
    const auto number = [&](std::size_t at) {
        std::size_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(file[at + i]);
        return value;
    };
    for (std::size_t at = 8; at + 8 <= file.size(); at += 12 + number(at)) {
        if (file.substr(at + 4, 4) != "tEXt") continue;
        const std::string text = file.substr(at + 8, number(at));
        const std::size_t end = text.find('\0');
        texts[text.substr(0, end)] = text.substr(end + 1);
    }
    return texts;
}

}  // namespace

/// The mean of the first samples of a pixel, computed from the request alone.
Rgb trueMean(const RenderRequest& request, int x, int y, int samples) {
    const auto world = compileScene(request);
    RgbSum sum(0.0);
    for (const RgbSum& value : probe::replayPixel(*world, request.seed, x, y, samples).values) sum += value;
    return Rgb(sum / static_cast<double>(samples));
}

bool haveSameBits(const Rgb& a, const Rgb& b) { return a == b || (a != a && b != b); }

bool checkSavedFile(const std::string& path, const SavedState& saved, const test::TemporaryFolder& folder) {
    auto texts = pngTexts(test::readText(path));
    const int samples = std::stoi(texts["rayscope:samples"]);
    const bool uneven = texts.contains("rayscope:samples.most");
    EXPECT_EQ(texts.contains("rayscope:scene.edited"), saved.state.scene->edited) << path;
    EXPECT_EQ(texts["rayscope:camera"], toOptions(saved.state.camera)) << path;
    EXPECT_EQ(texts["rayscope:setting.max_depth"], std::to_string(saved.state.settings.maxDepth)) << path;
    EXPECT_EQ(texts["rayscope:setting.exposure"], textOf(saved.state.settings, "exposure")) << path;
    if (uneven) {
        EXPECT_FALSE(texts.contains("rayscope:command"));
        return false;
    }
    RenderRequest request = requestOf(saved.state, saved.size.x, saved.size.y);
    const RgbImage file = readImage(path);
    // The picture may be that of the number of samples before the last edit, and is labelled with it.
    const int labelled = std::stoi(texts["rayscope:setting.spp"]);
    const bool countMatters = request.settings.sampler == SamplePattern::Jittered;
    request.settings.spp = countMatters ? labelled : samples;
    if (countMatters && samples != labelled) {
        EXPECT_FALSE(texts.contains("rayscope:command"));
        return false;
    }
    const std::string expected = (folder / "expected.png").string();
    writeRenderedImage(expected, renderImage(request).mean, request.settings);
    EXPECT_EQ(readImage(expected).pixels, file.pixels) << path;
    if (!texts.contains("rayscope:command")) return false;
    const test::ProgramResult result = test::run(folder, texts["rayscope:command"] + " --quiet -o again.png");
    EXPECT_EQ(result.exitCode, 0) << texts["rayscope:command"] << "\n" << result.err;
    EXPECT_EQ(readImage((folder / "again.png").string()).pixels, file.pixels) << texts["rayscope:command"];
    return true;
}

}  // namespace rayscope::viewer
