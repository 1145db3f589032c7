#include "cli/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/json_text.h"
#include "base/parse_number.h"
#include "base/printable_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/error_map_file.h"
#include "cli/output_files.h"
#include "measure/grading/grading_report.h"

namespace rayscope::cli {

namespace {

/// "0.02", "4/255" or "2%". Throws UsageError unless it is a number that is at least 0.
double amountOf(const std::string& option, std::string_view text) {
    const auto fail = [&] {
        throw UsageError(
            option, fmt::format("expected a number that is at least 0, such as 0.02, 4/255 or 2%, got {}",
                                base::quoted(text)));
    };
    double divisor = 1.0;
    std::string_view number = text;
    if (number.ends_with('%')) {
        number.remove_suffix(1);
        divisor = 100.0;
    } else if (const std::size_t slash = number.find('/'); slash != number.npos) {
        divisor = base::parseReal<double>(number.substr(slash + 1)).value_or(0.0);
        number = number.substr(0, slash);
    }
    const auto value = base::parseReal<double>(number);
    if (!value || !(divisor > 0.0) || !std::isfinite(*value / divisor) || *value < 0.0) fail();
    return *value / divisor;
}

double shareOf(std::string_view text) {
    const double share = amountOf("--share", text);
    if (share > 1.0)
        throw UsageError("--share", fmt::format("{} is more than all pixels; write 1% for one percent",
                                                base::quoted(text)));
    return share;
}

measure::MetricLimit limitOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos)
        throw UsageError("--limit", "expected METRIC=X, such as flip=0.05, got " + base::quoted(text));
    return {errorMetricNamed(text.substr(0, equals)), amountOf("--limit", text.substr(equals + 1))};
}

nlohmann::json toJson(const measure::Grade& grade, const measure::ImagePair& pair) {
    nlohmann::json result{{"name", grade.name},     {"image", pair.image},      {"reference", pair.reference},
                          {"passes", grade.passes}, {"reasons", grade.reasons}, {"score", grade.score},
                          {"verdict", nullptr}};
    if (const auto& verdict = grade.verdict)
        result["verdict"] = {{"pixels", verdict->pixels},
                             {"differing", verdict->differing},
                             {"share", verdict->share()},
                             {"over_hard_limit", verdict->overHardLimit},
                             {"non_finite", verdict->nonFinite},
                             {"largest", verdict->largest},
                             {"largest_at", {verdict->largestX, verdict->largestY}},
                             {"mean_difference", verdict->meanDifference}};
    return result;
}

/// The pairs to grade. Prints the names of images without a reference image.
std::vector<measure::ImagePair> pairsOf(const std::string& image, const std::string& reference) {
    if (!isFolder(reference)) return {{image, image, reference}};
    measure::ImagePairs found = measure::pairImages(image, reference);
    for (const std::string& name : found.unpaired)
        base::printMessage("{}: note: there is no reference image of this name\n", base::printable(name));
    return std::move(found.pairs);
}

void printVerdict(const measure::Grade& grade, const measure::GradingRules& rules, bool withScore) {
    std::string line =
        fmt::format("{}: {}: {}", base::printable(grade.name), grade.passes ? "passes" : "fails",
                    base::printable(measure::gradeText(grade, rules)));
    if (withScore) line += fmt::format("; score {:.1f}", grade.score);
    base::print("{}\n", line);
}

void writeDifference(const std::string& path, const measure::Grade& grade, const PixelRule& rule) {
    if (!grade.verdict)
        throw InputError("no differences are written, because the images cannot be compared", {path});
    const double range = grade.verdict->largest > 0.0 ? grade.verdict->largest : 1.0;
    writeErrorMap(path, differenceMap(grade.image, grade.reference, rule), range);
}

}  // namespace

bool isFolder(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

void VerdictOptions::addTo(OptionList& list) {
    list.add("--tolerance", &tolerance,
             "Verdict: a pixel differs if a channel differs by more than this, such as 4/255 or 2%; 0 by "
             "default")
        .form("X");
    list.add("--share", &share, "Verdict: pixels that may differ, such as 0.01 or 1%; none by default")
        .form("P");
    list.add("--hard-limit", &hardLimit, "Verdict: no pixel may differ by more than this").form("X");
    list.add("--neighbourhood", &neighbourhood,
             "Verdict: compare a pixel with the most similar one of the N x N around it; odd")
        .from(1, 15)
        .showDefault();
    list.add("--values", &values, "Verdict: compare what a display shows, 0 ... 1, or linear values")
        .choices({"display", "linear"})
        .showDefault();
    list.add("--limit", &limits, "Verdict: largest value of a metric, such as flip=0.05; repeatable")
        .form("METRIC=X");
    list.add("--score", &score,
             "Print a score: 100 minus ten times the mean difference in percent, at least 0");
    list.add("--html", &html, "Write a page with all pairs and a slider between reference and image")
        .form("FILE")
        .writes(Option::Output::File);
    list.add("--junit", &junit, "Write the verdicts as JUnit XML, for build servers")
        .form("FILE")
        .writes(Option::Output::File);
}

bool VerdictOptions::isAsked() const {
    return !tolerance.empty() || !share.empty() || !hardLimit.empty() || !limits.empty() || !html.empty() ||
           !junit.empty() || neighbourhood != 1 || score || values != "display";
}

measure::GradingRules VerdictOptions::rules() const {
    measure::GradingRules rules;
    if (!tolerance.empty()) rules.pixels.tolerance = amountOf("--tolerance", tolerance);
    if (!share.empty()) rules.pixels.share = shareOf(share);
    if (!hardLimit.empty()) rules.pixels.hardLimit = amountOf("--hard-limit", hardLimit);
    if (neighbourhood % 2 == 0)
        throw UsageError("--neighbourhood", fmt::format("expected an odd number, got {}", neighbourhood));
    rules.pixels.neighbourhood = neighbourhood;
    rules.pixels.values = values == "linear" ? ComparedValues::Linear : ComparedValues::Display;
    for (const std::string& limit : limits) rules.metrics.push_back(limitOf(limit));
    return rules;
}

int runVerdicts(const std::string& image, const std::string& reference, const VerdictOptions& options,
                const measure::GradingRules& rules, const std::string& difference, bool json) {
    if (isFolder(image) != isFolder(reference))
        throw InputError("expected two images or two folders", {isFolder(image) ? reference : image});
    if (isFolder(image) && !difference.empty())
        throw UsageError("-o", "writes the differences of two images; for folders use --html");
    const std::vector<measure::ImagePair> pairs = pairsOf(image, reference);
    OutputFiles files;
    measure::GradingPage page(rules);
    measure::JunitReport junit;
    nlohmann::json results = nlohmann::json::array();
    std::size_t passed = 0;
    for (const measure::ImagePair& pair : pairs) {
        const measure::Grade grade = measure::gradePair(pair, rules);
        passed += grade.passes;
        for (const Diagnostic& note : grade.notes) base::printMessage("{}\n", toString(note));
        if (json)
            results.push_back(toJson(grade, pair));
        else
            printVerdict(grade, rules, options.score);
        if (!options.html.empty()) page.add(grade);
        if (!options.junit.empty()) junit.add(grade, rules);
        if (!difference.empty())
            files.write(difference, [&] { writeDifference(difference, grade, rules.pixels); });
    }
    if (json)
        base::writeOutput(
            base::jsonText({{"passed", passed}, {"failed", pairs.size() - passed}, {"pairs", results}}));
    else if (isFolder(reference))
        base::print("{} of {} pass\n", passed, pairs.size());
    const std::string title = fmt::format("{} compared with {}", image, reference);
    if (!options.html.empty())
        files.write(options.html, [&] { base::writeFileAtomically(options.html, page.html(title)); });
    if (!options.junit.empty())
        files.write(options.junit, [&] { base::writeFileAtomically(options.junit, junit.xml(title)); });
    return files.exitCode(passed == pairs.size() ? kSuccess : kThresholdExceeded);
}

}  // namespace rayscope::cli
