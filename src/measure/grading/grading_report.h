#pragma once
// Reports on the verdicts of many pairs.
#include <string>
#include <vector>

#include "measure/grading/grade.h"

namespace rayscope::measure {

/// The rules in words: "A pair passes if at most 1 % of its pixels differ by more than 0.0157 …".
std::string describeRules(const GradingRules& rules);

/// One page with a slider between reference and image for each pair. The images are part of the page: add()
/// encodes them, so that the grades need not be kept.
class GradingPage {
  public:
    explicit GradingPage(const GradingRules& rules) : rules_(rules) {}
    void add(const Grade& grade);
    /// The complete page. `title` is text.
    std::string html(const std::string& title) const;

  private:
    GradingRules rules_;
    std::string rows_, pairs_;
    int count_ = 0, passed_ = 0;
};

/// Test cases in the XML format of JUnit, which build servers read.
class JunitReport {
  public:
    void add(const Grade& grade, const GradingRules& rules);
    std::string xml(const std::string& suite) const;

  private:
    std::string cases_;
    int count_ = 0, failed_ = 0;
};

}  // namespace rayscope::measure
