#pragma once
// The settings table: one row per field of Settings. Parsing, printing, the window, the documentation and the
// decision what to recompute are visitors of it.
#include <tuple>

#include "settings/descriptor.h"

namespace rayscope::settings {

namespace inactive {
constexpr std::string_view unless(bool active, std::string_view reason) {
    return active ? std::string_view{} : reason;
}
constexpr std::string_view recursion(const Settings& s) { return unless(s.recursion, "recursion is off"); }
constexpr std::string_view glossy(const Settings& s) {
    return unless(s.recursion && s.glossy, "glossy reflection is off");
}
constexpr std::string_view softShadows(const Settings& s) {
    return unless(s.softShadows, "soft shadows are off");
}
constexpr std::string_view anyShadows(const Settings& s) {
    return unless(s.transparency && (s.hardShadows || s.softShadows), "transparency or shadows are off");
}
constexpr std::string_view texture(const Settings& s) {
    return unless(s.textureMapping, "texture mapping is off");
}
constexpr std::string_view environment(const Settings& s) {
    return unless(s.environment, "the environment map is off");
}
constexpr std::string_view lens(const Settings& s) { return unless(s.depthOfField, "depth of field is off"); }
constexpr std::string_view bvh(const Settings& s) { return unless(s.bvh, "the BVH is off"); }
constexpr std::string_view wide(const Settings& s) {
    return unless(s.bvh && s.bvhLayout == BvhLayout::Wide,
                  "only the wide layout has kernels of several instruction sets");
}
constexpr std::string_view bins(const Settings& s) {
    return unless(s.bvh && usesBins(s.bvhBuilder), "only sah_binned and high use bins");
}
constexpr std::string_view bloom(const Settings& s) { return unless(s.bloom, "bloom is off"); }
constexpr std::string_view bloomSigma(const Settings& s) {
    return unless(s.bloom && s.bloomFilter == BloomFilter::Gaussian, "only the Gaussian filter has a sigma");
}
constexpr std::string_view bloomStage(const Settings& s) {
    return unless(s.bloom && s.bloomDebug, "the bloom debug view is off");
}
}  // namespace inactive

// clang-format off
inline constexpr std::tuple kSettingsTable{
    Toggle{{"shading", "Light", "Shading", "Phong shading; off shows the diffuse colour only."},
           &Settings::shading, Invalidates::Film},
    Toggle{{"hard_shadows", "Light", "Hard shadows", "Geometry blocks the light of point lights."},
           &Settings::hardShadows, Invalidates::Film},
    Toggle{{"soft_shadows", "Light", "Soft shadows",
           "Geometry blocks the light of segment and parallelogram lights."},
           &Settings::softShadows, Invalidates::Film},
    Range<int>{{"segment_samples", "Light", "Segment samples", "Samples per segment light.", "samples", Trade::Noise},
           &Settings::segmentSamples, 1, 4096, Invalidates::Film, alwaysActive, true},
    Range<int>{{"parallelogram_samples", "Light", "Parallelogram samples",
           "Samples along each side of a parallelogram light, which gets their square in total.", "samples per side", Trade::Noise},
           &Settings::parallelogramSamples, 1, 100, Invalidates::Film, alwaysActive, true},
    Choice<LightSampleCount, 2>{{"light_sample_count", "Light", "Light sample count",
           "Whether segment_samples and parallelogram_samples count per light or per unit of length."},
           &Settings::lightSampleCount, {"fixed", "per_length"}, Invalidates::Film},
    Toggle{{"transparent_shadows", "Light", "Transparent shadows",
           "Transparent surfaces attenuate shadow rays instead of blocking them.", "", Trade::Bias},
           &Settings::transparentShadows, Invalidates::Film, inactive::anyShadows},

    Toggle{{"recursion", "Reflection", "Recursion", "Specular surfaces reflect the scene."},
           &Settings::recursion, Invalidates::Film},
    Range<int>{{"max_depth", "Reflection", "Max depth", "Maximum number of reflections along a path.", "reflections", Trade::Bias},
           &Settings::maxDepth, 0, 16, Invalidates::Film, inactive::recursion},
    Choice<ReflectWhen, 2>{{"reflect_when", "Reflection", "Reflect when",
           "Which materials reflect: those with ks above 0, or those whose MTL illum is from 3 to 9."},
           &Settings::reflectWhen, {"ks", "illum"}, Invalidates::Film, inactive::recursion},
    Toggle{{"glossy", "Reflection", "Glossy", "Blurs reflections by a Gaussian lobe around the mirror direction."},
           &Settings::glossy, Invalidates::Film, inactive::recursion},
    Range<float>{{"glossy_sigma", "Reflection", "Glossy sigma",
           "Width of the lobe: its standard deviation is sigma / (3 shininess); 0 is a mirror."},
           &Settings::glossySigma, 0.0f, 100.0f, Invalidates::Film, inactive::glossy},
    Range<int>{{"glossy_samples", "Reflection", "Glossy samples",
           "Reflected rays at the first glossy reflection of a path; deeper reflections have one.", "rays", Trade::Noise},
           &Settings::glossySamples, 1, 4096, Invalidates::Film, inactive::glossy, true},

    Toggle{{"normal_interpolation", "Surface", "Normal interpolation",
           "Interpolates shading normals between vertex normals; off shades flat."},
           &Settings::normalInterpolation, Invalidates::Film},
    Toggle{{"transparency", "Surface", "Transparency", "Surfaces with opacity below 1 show what is behind them."},
           &Settings::transparency, Invalidates::Film},
    Toggle{{"texture_mapping", "Surface", "Texture mapping", "Textures replace the diffuse colour."},
           &Settings::textureMapping, Invalidates::Film},
    Choice<TextureFilter, 3>{{"texture_filter", "Surface", "Texture filter", "Filter of texture lookups; mipmap is trilinear.", "", Trade::Bias},
           &Settings::textureFilter, {"nearest", "bilinear", "mipmap"}, Invalidates::Film, inactive::texture},
    Toggle{{"environment", "Surface", "Environment", "Rays that hit nothing return the environment map."},
           &Settings::environment, Invalidates::Film},
    Toggle{{"reflection_map", "Surface", "Reflection map",
           "Surfaces show the environment map in the mirror direction."},
           &Settings::reflectionMap, Invalidates::Film, inactive::environment},

    Toggle{{"depth_of_field", "Camera", "Depth of field",
           "The lens of the camera blurs what is out of focus; off is a pinhole."},
           &Settings::depthOfField, Invalidates::Film},
    Range<int>{{"lens_samples", "Camera", "Lens samples", "Rays through the lens per pixel sample.", "rays", Trade::Noise},
           &Settings::lensSamples, 1, 512, Invalidates::Film, inactive::lens, true},
    Choice<LensShape, 3>{{"lens_shape", "Camera", "Lens shape", "Shape of the aperture."},
           &Settings::lensShape, {"disk", "square", "hexagon"}, Invalidates::Film, inactive::lens},
    Range<float>{{"sharp_zone", "Camera", "Sharp zone", "Geometry within this distance of the focus plane stays sharp.", "scene units"},
           &Settings::sharpZone, 0.0f, 1e9f, Invalidates::Film, inactive::lens},
    Toggle{{"motion_blur", "Camera", "Motion blur",
           "Samples moving objects over the time that the shutter is open."},
           &Settings::motionBlur, Invalidates::Film},

    Range<int>{{"spp", "Sampling", "Samples per pixel", "Camera rays per pixel.", "samples", Trade::Noise},
           &Settings::spp, 1, 1 << 20, Invalidates::Film, alwaysActive, true},
    Choice<SamplePattern, 3>{{"sampler", "Sampling", "Sampler",
           "Sampling pattern: independent, jittered grid, or Owen-scrambled Sobol points.", "", Trade::Noise},
           &Settings::sampler, {"independent", "jittered", "sobol"}, Invalidates::Film},

    Toggle{{"bvh", "Acceleration", "BVH", "Rays traverse a bounding volume hierarchy; off tests every primitive.", "", Trade::Speed},
           &Settings::bvh, Invalidates::Film},
    Choice<BvhBuilder, 4>{{"bvh_builder", "Acceleration", "BVH builder",
           "median splits at the median centroid along cycling axes. sah tests a split at every centroid by "
           "the surface area heuristic. sah_binned tests splits between bins only. high improves the tree "
           "of sah_binned by reinsertion, for long renders.", "", Trade::Speed},
           &Settings::bvhBuilder, {"median", "sah", "sah_binned", "high"}, Invalidates::Accel, inactive::bvh},
    Range<int>{{"bvh_bins", "Acceleration", "BVH bins", "Bins per axis of the builders sah_binned and high.", "bins", Trade::Speed},
           &Settings::bvhBins, 2, 4096, Invalidates::Accel, inactive::bins, true},
    Range<int>{{"bvh_max_level", "Acceleration", "BVH max level", "Deepest level of the tree; the root has level 0.", "", Trade::Speed},
           &Settings::bvhMaxLevel, 0, 64, Invalidates::Accel, inactive::bvh},
    Range<int>{{"bvh_leaf_size", "Acceleration", "BVH leaf size",
           "Maximum number of primitives in a leaf above the deepest level.", "primitives", Trade::Speed},
           &Settings::bvhLeafSize, 1, 64, Invalidates::Accel, inactive::bvh},
    Range<float>{{"bvh_refit", "Acceleration", "BVH refit",
           "A changed scene refits its BVH until the SAH cost exceeds this multiple of the cost at build; 0 "
           "always rebuilds.", "times"},
           &Settings::bvhRefit, 0.0f, 1000.0f, Invalidates::Accel, inactive::bvh},
    Choice<BvhLayout, 2>{{"bvh_layout", "Acceleration", "BVH layout",
           "Binary nodes, or wide nodes with up to 8 children; the image is the same.", "", Trade::Speed},
           &Settings::bvhLayout, {"binary", "wide"}, Invalidates::Accel, inactive::bvh},
    Choice<Isa, 5>{{"isa", "Acceleration", "Instruction set",
           "Instruction set of the traversal kernels of the wide layout; auto is the best available one; "
           "the image is the same."},
           &Settings::isa, {"auto", "scalar", "sse2", "avx2", "avx512"}, Invalidates::Accel, inactive::wide},

    Toggle{{"bloom", "Display", "Bloom", "Adds a glow around bright pixels."}, &Settings::bloom, Invalidates::Display},
    Choice<BloomFilter, 2>{{"bloom_filter", "Display", "Bloom filter", "Kernel of the glow.", "", Trade::Bias},
           &Settings::bloomFilter, {"box", "gaussian"}, Invalidates::Display, inactive::bloom},
    Range<float>{{"bloom_sigma", "Display", "Bloom sigma", "Standard deviation of the Gaussian kernel.", "pixels"},
           &Settings::bloomSigma, 0.0f, 100.0f, Invalidates::Display, inactive::bloomSigma},
    Range<float>{{"bloom_threshold", "Display", "Bloom threshold", "Pixels with a channel above this value glow."},
           &Settings::bloomThreshold, 0.0f, 1000.0f, Invalidates::Display, inactive::bloom},
    Range<int>{{"bloom_size", "Display", "Bloom size", "Radius of the kernel, which is 2 size + 1 pixels wide.", "pixels", Trade::Bias},
           &Settings::bloomSize, 0, 500, Invalidates::Display, inactive::bloom},
    Range<float>{{"bloom_scale", "Display", "Bloom scale", "Factor of the glow before it is added."},
           &Settings::bloomScale, 0.0f, 100.0f, Invalidates::Display, inactive::bloom},
    Toggle{{"bloom_debug", "Display", "Bloom debug", "Shows one stage of the bloom instead of the image."},
           &Settings::bloomDebug, Invalidates::Display, inactive::bloom},
    Choice<BloomStage, 3>{{"bloom_stage", "Display", "Bloom stage", "Stage that bloom_debug shows."},
           &Settings::bloomStage, {"thresholded", "filtered", "added"}, Invalidates::Display, inactive::bloomStage},
    Range<float>{{"exposure", "Display", "Exposure", "Scales the brightness by 2^exposure.", "stops"},
           &Settings::exposure, -20.0f, 20.0f, Invalidates::Display},
    Choice<Encoding, 2>{{"tone", "Display", "Display encoding",
           "Encoding of displayed and 8-bit images: the sRGB curve, or clamped linear values (course), to "
           "compare with images of programs without colour management."},
           &Settings::tone, {"srgb", "course"}, Invalidates::Display},
};
// clang-format on

/// Calls visit(descriptor) for each row in order.
template <class Visit>
constexpr void forEachSetting(Visit&& visit) {
    std::apply([&](const auto&... row) { (visit(row), ...); }, kSettingsTable);
}

namespace detail {
struct AnyField {
    template <class T>
    constexpr operator T() const;
};
template <class T, class... Fields>
consteval std::size_t countFields() {
    if constexpr (requires { T{Fields{}..., AnyField{}}; })
        return countFields<T, Fields..., AnyField>();
    else
        return sizeof...(Fields);
}
}  // namespace detail
static_assert(detail::countFields<Settings>() == std::tuple_size_v<decltype(kSettingsTable)>,
              "each field of Settings needs exactly one row in the table");

}  // namespace rayscope::settings
