#pragma once
// Whether an image is close enough to a reference image: rules for graders and regression tests.
#include <rayscope/image.h>
#include <optional>

namespace rayscope {

/// The values that a PixelRule compares.
enum class ComparedValues {
    Display,  ///< clamped to 0 … 1 and encoded with the sRGB curve, in steps of 1/65535: what 8- and 16-bit
              ///< files store
    Linear    ///< as they are
};

/// When two images count as equal. The difference of a pixel is that of its channels one by one; what is
/// compared with the limits is the largest of the three.
struct PixelRule {
    ComparedValues values = ComparedValues::Display;
    double tolerance = 0.0;           ///< a pixel differs if its difference is larger; ≥ 0
    double share = 0.0;               ///< of the pixels that may differ, 0 … 1
    std::optional<double> hardLimit;  ///< no pixel may differ by more; ≥ 0

    /// Edge length in pixels, odd, 1 … 15, of the square within which a pixel may lie elsewhere: each pixel
    /// of one image is compared with the pixel of the square around it in the other image whose channels
    /// differ least in sum. That is done in both directions, and the larger of the two differences counts.
    int neighbourhood = 1;
};

struct PixelVerdict {
    bool passes = false;
    long long pixels = 0;
    long long differing = 0;  ///< by more than the tolerance
    long long overHardLimit = 0;
    long long nonFinite = 0;         ///< pixels with NaN or infinity in one of the images: they differ, and
                                     ///< exceed the hard limit
    double largest = 0.0;            ///< difference of a finite pixel
    int largestX = 0, largestY = 0;  ///< the first pixel with it
    double meanDifference = 0.0;     ///< absolute, over all channels; 1 for a pixel that is not finite

    /// The share of the pixels that differ, 0 … 1.
    double share() const { return static_cast<double>(differing) / static_cast<double>(pixels); }
    /// 100 minus ten times the mean difference in percent, at least 0: 100 for equal images, 0 if the values
    /// differ by a tenth on average.
    double score() const;
};

/// Applies a rule. Throws InputError if the sizes differ or there are no pixels, and std::invalid_argument
/// unless hasAllPixels() and the rule is in range.
PixelVerdict judgePixels(const RgbImage& image, const RgbImage& reference, const PixelRule& rule);

/// The difference of each pixel that a rule compares with its limits; NaN where one of the pixels is not
/// finite. Throws like judgePixels().
Image<double> differenceMap(const RgbImage& image, const RgbImage& reference, const PixelRule& rule);

}  // namespace rayscope
