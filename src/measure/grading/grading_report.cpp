#include "measure/grading/grading_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/base64.h"
#include "measure/report/report_template.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope::measure {

namespace {

const ReportTemplate& gradingParts() {
    static const ReportTemplate embedded = embeddedTemplate("grading.html");
    return embedded;
}

std::string pictureUri(const RgbImage& image) {
    return "data:image/png;base64," + base::base64Encoded(encodeImage(".png", image));
}

std::string pictures(const Grade& grade, const PixelRule& rule) {
    if (grade.verdict) {
        const double range = grade.verdict->largest > 0.0 ? grade.verdict->largest : 1.0;
        const RgbImage difference = applyColorMap(differenceMap(grade.image, grade.reference, rule), range);
        return gradingParts().fill("pictures", {{"reference", pictureUri(grade.reference)},
                                                {"image", pictureUri(grade.image)},
                                                {"difference", pictureUri(difference)},
                                                {"range", fmt::format("{:.4g}", range)}});
    }
    std::string alone;
    for (const auto& [label, image] :
         {std::pair{"Reference", &grade.reference}, std::pair{"Yours", &grade.image}})
        if (!image->empty())
            alone += gradingParts().fill("alone", {{"label", label}, {"picture", pictureUri(*image)}});
    return alone;
}

}  // namespace

std::string describeRules(const GradingRules& rules) {
    const PixelRule& rule = rules.pixels;
    std::string text = "A pair passes if ";
    if (rule.share == 0.0)
        text += "no pixel differs";
    else
        text += fmt::format("at most {:.4g} % of the pixels differ", 100.0 * rule.share);
    text += fmt::format(" by more than {:.4g}", rule.tolerance);
    if (rule.hardLimit) text += fmt::format(", none by more than {:.4g}", *rule.hardLimit);
    for (const MetricLimit& limit : rules.metrics)
        text += fmt::format(", {} is at most {:.6g}", nameOf(limit.metric), limit.most);
    text += rule.values == ComparedValues::Display ? ". Values are those of a display, 0 … 1"
                                                   : ". Values are linear";
    if (rule.neighbourhood > 1)
        text += fmt::format("; a pixel is compared with the most similar one of the {0} × {0} around it",
                            rule.neighbourhood);
    return text + ".";
}

void GradingPage::add(const Grade& grade) {
    const std::string number = std::to_string(++count_);
    passed_ += grade.passes;
    const std::string name = escaped(grade.name), cssClass = grade.passes ? "good" : "bad",
                      verdict = grade.passes ? "passes" : "fails", score = fmt::format("{:.1f}", grade.score),
                      text = escaped(gradeText(grade, rules_));
    rows_ += gradingParts().fill("row", {{"number", number},
                                         {"name", name},
                                         {"class", cssClass},
                                         {"verdict", verdict},
                                         {"score", score},
                                         {"text", text}}) +
             "\n";
    pairs_ += gradingParts().fill("pair", {{"number", number},
                                           {"name", name},
                                           {"class", cssClass},
                                           {"verdict", verdict},
                                           {"score", score},
                                           {"text", text},
                                           {"pictures", pictures(grade, rules_.pixels)}}) +
              "\n";
}

std::string GradingPage::html(const std::string& title) const {
    const std::string facts = reportFact(std::to_string(passed_), "pass") + "\n" +
                              reportFact(std::to_string(count_ - passed_), "fail") + "\n";
    return reportPage(title, gradingParts().fill("body", {{"title", escaped(title)},
                                                          {"rule", escaped(describeRules(rules_))},
                                                          {"facts", facts},
                                                          {"rows", rows_},
                                                          {"pairs", pairs_}}));
}

void JunitReport::add(const Grade& grade, const GradingRules& rules) {
    ++count_;
    failed_ += !grade.passes;
    const std::string text = escaped(gradeText(grade, rules));
    cases_ += fmt::format("  <testcase classname=\"compare\" name=\"{}\">", escaped(grade.name));
    if (grade.passes)
        cases_ += fmt::format("<system-out>{}; score {:.1f}</system-out>", text, grade.score);
    else
        cases_ += fmt::format("<failure message=\"{}\"/>", text);
    cases_ += "</testcase>\n";
}

std::string JunitReport::xml(const std::string& suite) const {
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n"
        "{}</testsuite>\n",
        escaped(suite), count_, failed_, cases_);
}

}  // namespace rayscope::measure
