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

/// How a scene is rendered and displayed. The meaning, unit and range of each field are in the settings table
/// (src/settings/table.h; printed in docs/settings.md), in the order of the fields. An effect that the scene
/// does not contain costs nothing, whatever its setting.
struct Settings {
    // Light.
    bool shading = true;
    bool hardShadows = true;
    bool softShadows = true;
    int segmentSamples = 16;
    int parallelogramSamples = 4;
    LightSampleCount lightSampleCount = LightSampleCount::Fixed;
    bool transparentShadows = false;

    // Reflection.
    bool recursion = true;
    int maxDepth = 5;
    ReflectWhen reflectWhen = ReflectWhen::Ks;
    bool glossy = false;
    float glossySigma = 1.0f;
    int glossySamples = 16;

    // Surface.
    bool normalInterpolation = true;
    bool transparency = true;
    bool textureMapping = true;
    TextureFilter textureFilter = TextureFilter::Bilinear;
    bool environment = true;
    bool reflectionMap = false;

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

/// Whether the builder uses Settings::bvhBins.
constexpr bool usesBins(BvhBuilder builder) {
    return builder == BvhBuilder::SahBinned || builder == BvhBuilder::SahReinsertion;
}

/// What a change of settings invalidates; each includes those before it.
enum class Invalidates { Nothing, Display, Film, Accel };

/// What a setting trades against render time.
enum class Trade {
    Nothing,  ///< a choice of what is rendered, not of its quality
    Noise,    ///< noise; the expected image stays the same
    Bias,     ///< bias, which no number of samples removes
    Speed     ///< nothing: the image stays the same, bit for bit
};

/// The maximum over the fields in which a and b differ.
Invalidates changed(const Settings& a, const Settings& b);

/// `traced` with the fields of `display` that apply to finished pixels: those that invalidate no more than
/// the display.
Settings withDisplayOf(const Settings& traced, const Settings& display);

/// Throws std::invalid_argument, with the key and the range, if a value is out of the range of its setting.
void checkSettings(const Settings& settings);

/// Sets the field of `key` from text. Throws InputError, without a position, if the value is invalid or the
/// key unknown; the message has the expected values or the nearest key. Settings stay unchanged then.
void assign(Settings& settings, std::string_view key, std::string_view value);

/// The value of `key` as text that assign() reads back to the same value. Throws InputError if the key is
/// unknown.
std::string textOf(const Settings& settings, std::string_view key);

/// Named values of the settings that trade noise or bias against render time.
struct Preset {
    std::string_view name, meaning;
    std::vector<std::pair<std::string_view, std::string_view>> values;  ///< key, text

    /// Override `values` where a lens or motion blurs the pixels: there the variance over the lens or time
    /// exceeds that over a light, so that more light samples per pixel sample gain little.
    std::vector<std::pair<std::string_view, std::string_view>> valuesIfBlurred;
};
/// preview, balanced, final, reference: from fast to accurate.
const std::vector<Preset>& presets();
/// Throws InputError, with the nearest name, if there is no such preset.
const Preset& presetNamed(std::string_view name);
/// Assigns the values of the preset; other settings keep theirs. For `blurred` see blursPixels().
void applyPreset(Settings& settings, const Preset& preset, bool blurred);

/// Every key, in the order of the table.
std::vector<std::string_view> settingKeys();

/// The description of one setting for users.
struct SettingInfo {
    std::string_view key, group, label, help, unit;
    Trade trade = Trade::Nothing;
    std::string kind;          ///< "boolean", "integer", "number" or "choice"
    std::string values;        ///< valid values as text: "true, false", "1 … 4096", "box, gaussian"
    std::string defaultValue;  ///< as text, see textOf()
    double lowest = 0.0, highest = 0.0;     ///< range of an integer or number, inclusive
    std::vector<std::string_view> choices;  ///< names of a choice
};
/// All settings, in the order of the table.
std::vector<SettingInfo> describeSettings();

}  // namespace rayscope
