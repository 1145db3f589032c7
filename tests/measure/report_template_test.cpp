#include "measure/report/report_template.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rayscope {
namespace {

constexpr const char* kText =
    "<!-- part row -->\n<td>{{a}}</td><td>{{long name}}</td>\n<!-- part empty -->\n<!-- part two lines -->\n"
    "{{a}}\n{{a}}\n";

TEST(ReportTemplate, FillsThePlaceholdersOfAPart) {
    const measure::ReportTemplate parts(kText);
    EXPECT_EQ(parts.fill("row", {{"long name", "2"}, {"a", "1"}}), "<td>1</td><td>2</td>");
    EXPECT_EQ(parts.fill("empty", {}), "");
    EXPECT_EQ(parts.fill("two lines", {{"a", "x"}}), "x\nx");
    EXPECT_EQ(parts.fill("two lines", {{"a", "{{b}}"}}), "{{b}}\n{{b}}") << "values are not filled again";
}

TEST(ReportTemplate, FailsOnUnknownAndUnusedNames) {
    const measure::ReportTemplate parts(kText);
    EXPECT_THROW(parts.fill("row", {{"a", "1"}}), std::logic_error) << "placeholder without a value";
    EXPECT_THROW(parts.fill("row", {{"a", "1"}, {"long name", "2"}, {"b", "3"}}), std::logic_error)
        << "value without a placeholder";
    EXPECT_THROW(parts.fill("rows", {}), std::logic_error);
    EXPECT_THROW(measure::ReportTemplate("<b>{{a}}</b>"), std::logic_error);
    EXPECT_THROW(measure::ReportTemplate("<!-- part a -->\n{{b").fill("a", {{"b", ""}}), std::logic_error);
    EXPECT_THROW(measure::ReportTemplate("<!-- part a -->\n<!-- part a -->\n"), std::logic_error);
    EXPECT_THROW(measure::embeddedTemplate("missing.html"), std::logic_error);
}

TEST(ReportTemplate, PagesEscapeTextAndLoadNothing) {
    const std::string page = measure::reportPage("<scene>", measure::reportRemarks({"a & b"}));
    EXPECT_NE(page.find("<title>&lt;scene&gt;</title>"), std::string::npos);
    EXPECT_NE(page.find("a &amp; b"), std::string::npos);
    for (const char* reference : {"src=", "href=", "@import", "url("})
        EXPECT_EQ(page.find(reference), std::string::npos) << reference;
}

}  // namespace
}  // namespace rayscope
