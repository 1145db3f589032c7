#include "measure/grading/grade.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rayscope/diagnostics.h>
#include <cmath>

namespace rayscope::measure {

namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

/// Appends why the pixels do not pass.
void explain(const PixelVerdict& verdict, const PixelRule& rule, std::vector<std::string>& reasons) {
    if (verdict.passes) return;
    if (verdict.share() > rule.share)
        reasons.push_back(fmt::format("{} of the pixels differ by more than {:.4g}; at most {} may",
                                      percent(verdict.share()), rule.tolerance, percent(rule.share)));
    if (verdict.overHardLimit > 0)
        reasons.push_back(fmt::format("{} pixels differ by more than the hard limit of {:.4g}",
                                      verdict.overHardLimit, *rule.hardLimit));
    if (verdict.nonFinite > 0)
        reasons.push_back(fmt::format("{} pixels are NaN or infinite", verdict.nonFinite));
}

void checkMetrics(Grade& grade, const GradingRules& rules) {
    for (const MetricLimit& limit : rules.metrics) {
        const double error =
            scoreOf(errorMap(grade.image, grade.reference, limit.metric, rules.measure), limit.metric);
        if (error <= limit.most) continue;
        grade.passes = false;
        grade.reasons.push_back(
            fmt::format("{} is {:.6g}; at most {:.6g} may be", nameOf(limit.metric), error, limit.most));
    }
}

}  // namespace

Grade gradePair(const ImagePair& pair, const GradingRules& rules) {
    Grade grade;
    grade.name = pair.name;
    const auto read = [&](const std::string& path) -> RgbImage {
        try {
            return readImage(path, &grade.notes);
        } catch (const InputError& error) {
            grade.reasons.push_back(toString(error.diagnostic()));
            return {};
        }
    };
    grade.reference = read(pair.reference);
    if (pair.image.empty())
        grade.reasons.push_back("there is no image of this name");
    else
        grade.image = read(pair.image);
    if (!grade.reasons.empty()) return grade;
    if (grade.image.width != grade.reference.width || grade.image.height != grade.reference.height) {
        grade.reasons.push_back(fmt::format("the image has {} x {} pixels, the reference {} x {}",
                                            grade.image.width, grade.image.height, grade.reference.width,
                                            grade.reference.height));
        return grade;
    }
    grade.verdict = judgePixels(grade.image, grade.reference, rules.pixels);
    grade.score = grade.verdict->score();
    grade.passes = grade.verdict->passes;
    explain(*grade.verdict, rules.pixels, grade.reasons);
    checkMetrics(grade, rules);
    return grade;
}

std::string gradeText(const Grade& grade, const GradingRules& rules) {
    if (!grade.passes) return fmt::format("{}", fmt::join(grade.reasons, "; "));
    const PixelVerdict& verdict = *grade.verdict;
    if (verdict.largest == 0.0 && verdict.nonFinite == 0) return "equal";
    return fmt::format("{} of the pixels differ by more than {:.4g}, the largest by {:.4g} at pixel {},{}",
                       percent(verdict.share()), rules.pixels.tolerance, verdict.largest, verdict.largestX,
                       verdict.largestY);
}

}  // namespace rayscope::measure
