#include "measure/report/report_template.h"

#include <algorithm>
#include <stdexcept>

#include "embedded_report.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope::measure {

namespace {

constexpr std::string_view kPartBegin = "<!-- part ", kPartEnd = " -->";

[[noreturn]] void fail(const std::string& what, std::string_view name) {
    throw std::logic_error("report template: " + what + " '" + std::string(name) + "'");
}

std::string_view embeddedFile(std::string_view name) {
    for (const auto& file : report::files())
        if (file.name == name) return file.content;
    fail("no embedded file", name);
}

const ReportTemplate& pageTemplate() {
    static const ReportTemplate page = embeddedTemplate("page.html");
    return page;
}

}  // namespace

ReportTemplate::ReportTemplate(std::string_view text) {
    if (!text.starts_with(kPartBegin)) fail("expected a part, found", text.substr(0, 20));
    while (!text.empty()) {
        const std::size_t nameEnd = text.find(kPartEnd);
        if (nameEnd == std::string_view::npos) fail("unfinished part", text.substr(0, 20));
        const std::string_view name = text.substr(kPartBegin.size(), nameEnd - kPartBegin.size());
        text.remove_prefix(nameEnd + kPartEnd.size());
        // The text begins with the newline of the part's first line.
        const std::size_t next = std::min(text.find("\n" + std::string(kPartBegin)), text.size());
        std::string_view content = text.substr(0, next);
        if (content.starts_with('\n')) content.remove_prefix(1);
        if (content.ends_with('\n')) content.remove_suffix(1);
        text.remove_prefix(std::min(next + 1, text.size()));
        if (!parts_.emplace(name, content).second) fail("two parts", name);
    }
}

std::string ReportTemplate::fill(std::string_view part, Values values) const {
    const auto found = parts_.find(part);
    if (found == parts_.end()) fail("no part", part);
    std::string_view rest = found->second;
    std::vector<bool> used(values.size(), false);
    std::string result;
    for (std::size_t begin = rest.find("{{"); begin != std::string_view::npos; begin = rest.find("{{")) {
        const std::size_t end = rest.find("}}", begin);
        if (end == std::string_view::npos) fail("unfinished placeholder in part", part);
        const std::string_view name = rest.substr(begin + 2, end - begin - 2);
        const auto* value =
            std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
        if (value == values.end()) fail("no value for placeholder", name);
        used[static_cast<std::size_t>(value - values.begin())] = true;
        result.append(rest.substr(0, begin)).append(value->second);
        rest.remove_prefix(end + 2);
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i]) fail("no placeholder for value", (values.begin() + i)->first);
    return result.append(rest);
}

ReportTemplate embeddedTemplate(std::string_view file) { return ReportTemplate(embeddedFile(file)); }

std::string reportPage(const std::string& title, const std::string& body) {
    return pageTemplate().fill("page", {{"title", escaped(title)},
                                        {"style", std::string(embeddedFile("report.css"))},
                                        {"body", body}}) +
           "\n";
}

std::string reportFact(const std::string& value, const std::string& meaning) {
    return pageTemplate().fill("fact", {{"value", value}, {"meaning", meaning}}) + "\n";
}

std::string reportRemarks(const std::vector<std::string>& remarks) {
    std::string paragraphs;
    for (const std::string& remark : remarks)
        paragraphs += pageTemplate().fill("remark", {{"text", escaped(remark)}}) + "\n";
    return paragraphs;
}

}  // namespace rayscope::measure
