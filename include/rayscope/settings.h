#pragma once
#include <rayscope/image.h>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rayscope {

enum class ReflectWhen { Ks, Illum };
enum class LightSampleCount { Fixed, PerLength };
enum class TextureFilter { Nearest, Bilinear, Mipmap };
enum class SamplePattern { Independent, Jittered, Sobol };
enum class LensShape { Disk, Square, Hexagon };
enum class BloomFilter { Box, Gaussian };
enum class BloomStage { Thresholded, Filtered, Added };
enum class BvhBuilder { Median, Sah, SahBinned, SahReinsertion };
enum class BvhLayout { Binary, Wide };
enum class Isa { Auto, Scalar, Sse2, Avx2, Avx512 };

/// How a scene is computed and shown, as a plain value. What each field means, its unit and its range stand
/// in the one table of src/settings/table.h, from which the command line, the window and the documentation
/// are made. An effect that a scene does not contain has no cost, whatever is said here.
struct Settings {
    // Light transport.
    bool shading = true;
    bool recursion = true;
    int maxDepth = 5;
    ReflectWhen reflectWhen = ReflectWhen::Ks;
    bool hardShadows = true;
    bool softShadows = true;
    int segmentSamples = 16;
    int parallelogramSamples = 4;
    LightSampleCount lightSampleCount = LightSampleCount::Fixed;
    bool normalInterpolation = true;
    bool textureMapping = true;
    TextureFilter textureFilter = TextureFilter::Bilinear;
    bool environment = true;
    bool reflectionMap = false;
    bool glossy = false;
    float glossySigma = 1.0f;
    int glossySamples = 16;
    bool transparency = true;
    bool transparentShadows = false;

    // Camera.
    bool depthOfField = true;
    int lensSamples = 1;
    LensShape lensShape = LensShape::Disk;
    float sharpZone = 0.0f;
    bool motionBlur = true;

    // Sampling.
    int spp = 16;
    SamplePattern sampler = SamplePattern::Sobol;

    // Acceleration.
    bool bvh = true;
    BvhBuilder bvhBuilder = BvhBuilder::SahBinned;
    int bvhBins = 32;
    int bvhMaxLevel = 64;
    int bvhLeafSize = 4;
    float bvhRefit = 1.2f;
    BvhLayout bvhLayout = BvhLayout::Wide;
    Isa isa = Isa::Auto;

    // Display.
    bool bloom = false;
    BloomFilter bloomFilter = BloomFilter::Gaussian;
    float bloomSigma = 1.0f;
    float bloomThreshold = 0.7f;
    int bloomSize = 2;
    float bloomScale = 1.0f;
    bool bloomDebug = false;
    BloomStage bloomStage = BloomStage::Filtered;
    float exposure = 0.0f;
    Encoding tone = Encoding::Srgb;

    bool operator==(const Settings&) const = default;
};

/// Whether Settings::bvhBins says something to a builder.
constexpr bool usesBins(BvhBuilder builder) {
    return builder == BvhBuilder::SahBinned || builder == BvhBuilder::SahReinsertion;
}

/// How much of the work a change of settings throws away, from nothing to everything.
enum class Invalidates { Nothing, Display, Film, Accel };

/// What a setting trades against time.
enum class Trade {
    Nothing,  ///< it says what is shown, not how well
    Noise,    ///< more work makes less noise
    Bias,     ///< less work makes another picture, however many samples there are
    Speed     ///< the picture stays the same, bit for bit
};

/// The worst consequence among the fields in which a and b differ.
Invalidates changed(const Settings& a, const Settings& b);

/// Sets the field named `key` from text. Throws InputError (without position) that says what was expected,
/// and for an unknown key names the nearest one.
void assign(Settings& settings, std::string_view key, std::string_view value);

/// The text that assign() would accept for the present value of `key`.
std::string textOf(const Settings& settings, std::string_view key);

/// A position on the dial from fast to accurate: values for the settings that trade.
struct Preset {
    std::string_view name, meaning;
    std::vector<std::pair<std::string_view, std::string_view>> values;  ///< key, text
    /// These in their place where a lens or motion blurs the pixels: then what lies behind a pixel differs
    /// more than what a light looks like from there.
    std::vector<std::pair<std::string_view, std::string_view>> valuesIfBlurred;
};
/// preview, balanced, final, reference.
const std::vector<Preset>& presets();
/// Throws InputError that names the nearest preset.
const Preset& presetNamed(std::string_view name);
/// Sets what the preset says and leaves the rest.
void applyPreset(Settings& settings, const Preset& preset, bool blurred);

/// Every key, in the order of the table.
std::vector<std::string_view> settingKeys();

/// What a user can know about one setting.
struct SettingInfo {
    std::string_view key, group, label, help, unit;
    Trade trade = Trade::Nothing;
    std::string kind;  ///< "boolean", "integer", "number" or "choice"
    std::string defaultValue;
    double lowest = 0.0, highest = 0.0;     ///< of numbers
    std::vector<std::string_view> choices;  ///< of choices
};
std::vector<SettingInfo> describeSettings();

}  // namespace rayscope
