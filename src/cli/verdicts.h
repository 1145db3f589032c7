#pragma once
// The verdicts of `rayscope compare`: rules for graders and regression tests, on two images or two folders.
#include <string>
#include <vector>

#include "measure/grading/grade.h"

namespace rayscope::cli {

class OptionList;

struct VerdictOptions {
    std::string tolerance, share, hardLimit, html, junit;
    std::string values = "display";
    std::vector<std::string> limits;  ///< METRIC=X
    int neighbourhood = 1;
    bool score = false;

    void addTo(OptionList& list);
    /// Whether an option asks for a verdict.
    bool isAsked() const;
    /// Without the metric limits of other options. Throws UsageError.
    measure::GradingRules rules() const;
};

bool isFolder(const std::string& path);

/// Grades two images or, if `reference` is a folder, those of two folders; prints one line per pair, or JSON,
/// and writes the reports. Writes the differences of two images to `difference` unless it is empty. Returns
/// the exit code.
int runVerdicts(const std::string& image, const std::string& reference, const VerdictOptions& options,
                const measure::GradingRules& rules, const std::string& difference, bool json);

}  // namespace rayscope::cli
