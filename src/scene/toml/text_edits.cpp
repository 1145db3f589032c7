#include "scene/toml/text_edits.h"

#include <algorithm>
#include <utility>

namespace rayscope::scene {

TextEdits::TextEdits(std::string text) : text_(std::move(text)), lineStarts_{0} {
    for (std::size_t at = 0; at < text_.size(); ++at)
        if (text_[at] == '\n') lineStarts_.push_back(at + 1);
}

std::size_t TextEdits::startOf(toml::source_index line) const {
    return line <= lineStarts_.size() ? lineStarts_[line - 1] : text_.size();
}

/// Columns count characters, of which UTF-8 may need several bytes.
std::size_t TextEdits::offsetOf(const toml::source_position& position) const {
    std::size_t at = startOf(position.line);
    for (toml::source_index column = 1; column < position.column && at < text_.size(); ++column) do
            ++at;
        while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0u) == 0x80u);
    return at;
}

void TextEdits::replace(const toml::node& value, std::string replacement) {
    edits_.push_back({offsetOf(value.source().begin), offsetOf(value.source().end), std::move(replacement)});
}

void TextEdits::insertBelow(toml::source_index line, const std::string& key, const std::string& value) {
    const std::size_t at = startOf(line + 1);
    const bool unfinished = at > 0 && text_[at - 1] != '\n';
    edits_.push_back({at, at, (unfinished ? "\n" : "") + key + " = " + value + "\n"});
}

void TextEdits::removeLines(toml::source_index first, toml::source_index last) {
    edits_.push_back({startOf(first), startOf(last + 1), ""});
}

std::string TextEdits::result() const {
    std::vector<Edit> edits = edits_;
    std::stable_sort(edits.begin(), edits.end(),
                     [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string changed;
    std::size_t at = 0;
    for (const Edit& edit : edits) {
        if (edit.begin > at) changed.append(text_, at, edit.begin - at);
        changed += edit.replacement;
        at = std::max(at, edit.end);
    }
    changed.append(text_, at);
    if (!appended_.empty() && !changed.empty() && changed.back() != '\n') changed += '\n';
    return changed + appended_;
}

toml::source_index lastLineOf(const toml::node& node) {
    toml::source_index last = node.source().end.line;
    if (const toml::table* table = node.as_table())
        for (auto&& [key, value] : *table) last = std::max(last, lastLineOf(value));
    if (const toml::array* array = node.as_array())
        for (const toml::node& value : *array) last = std::max(last, lastLineOf(value));
    return last;
}

}  // namespace rayscope::scene
