#pragma once
// Verdicts on images of hand-ins or of regression tests.
#include <rayscope/compare.h>
#include <rayscope/verdict.h>
#include <optional>
#include <string>
#include <vector>

#include "measure/grading/image_pairs.h"

namespace rayscope::measure {

/// The largest value of a metric that passes.
struct MetricLimit {
    ErrorMetric metric = ErrorMetric::Rmse;
    double most = 0.0;
};

struct GradingRules {
    PixelRule pixels;
    std::vector<MetricLimit> metrics;
    CompareOptions measure;
};

/// The verdict on one pair.
struct Grade {
    std::string name;
    bool passes = false;
    std::vector<std::string> reasons;     ///< why it fails, one phrase each; empty if it passes
    std::optional<PixelVerdict> verdict;  ///< nothing if an image is missing, damaged or of another size
    double score = 0.0;                   ///< of the verdict, 0 without one
    RgbImage image, reference;            ///< as far as they could be read
    Diagnostics notes;                    ///< of the readers
};

/// Reads the images and applies all rules. A file that cannot be read makes the pair fail and says why.
Grade gradePair(const ImagePair& pair, const GradingRules& rules);

/// "0.12 % of the pixels differ by more than 0.0157, the largest by 0.0314 at pixel 3,4; score 98.7", or the
/// reasons.
std::string gradeText(const Grade& grade, const GradingRules& rules);

}  // namespace rayscope::measure
