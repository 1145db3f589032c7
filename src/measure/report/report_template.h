#pragma once
// HTML templates of the reports; the files in this folder are compiled into the binary.
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rayscope::measure {

/// A text of named parts, each begun by a line `<!-- part NAME -->`, with placeholders `{{name}}`.
class ReportTemplate {
  public:
    /// The value of each placeholder, inserted as it is: callers escape text, see escaped().
    using Values = std::initializer_list<std::pair<std::string_view, std::string>>;

    /// Throws std::logic_error if the text does not begin with a part.
    explicit ReportTemplate(std::string_view text);

    /// A part, without the newline at its end, with values for its placeholders. Placeholders inside values
    /// are not replaced. Throws std::logic_error if there is no such part, a placeholder has no value, or a
    /// value has no placeholder.
    std::string fill(std::string_view part, Values values) const;

  private:
    std::map<std::string, std::string, std::less<>> parts_;
};

/// The template in the embedded file of that name. Throws std::logic_error if there is none.
ReportTemplate embeddedTemplate(std::string_view file);

/// A complete page that loads no other file; `title` is text, `body` HTML.
std::string reportPage(const std::string& title, const std::string& body);

/// A figure with its meaning, both HTML, for the head of a report.
std::string reportFact(const std::string& value, const std::string& meaning);

/// Remarks as paragraphs, from text.
std::string reportRemarks(const std::vector<std::string>& remarks);

}  // namespace rayscope::measure
