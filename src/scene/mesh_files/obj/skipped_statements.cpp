#include "scene/mesh_files/obj/skipped_statements.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::scene {

namespace {

constexpr std::size_t kMaxKeywords = 12, kMaxLength = 32;

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool looksLikeKeyword(std::string_view word) {
    return isLetter(word.front()) && std::all_of(word.begin(), word.end(), [](char c) {
               return isLetter(c) || c == '_' || (c >= '0' && c <= '9');
           });
}

}  // namespace

void SkippedStatements::add(std::string_view keyword, int line) {
    if (!looksLikeKeyword(keyword)) {
        if (others_++ == 0) firstOther_ = line;
        return;
    }
    if (keywords_.contains(keyword)) return;
    if (keyword.size() > kMaxLength) {
        add(std::string(keyword.substr(0, kMaxLength - 3)) + "___", line);
        return;
    }
    if (keywords_.size() < kMaxKeywords)
        keywords_.emplace(keyword);
    else
        isListFull_ = true;
}

void SkippedStatements::report(std::string_view format, Oddities& oddities) const {
    if (!keywords_.empty())
        oddities.add(Severity::Note, fmt::format("ignored statements: {}{}", fmt::join(keywords_, ", "),
                                                 isListFull_ ? " and others" : ""));
    oddities.add(Severity::Warning, fmt::format("lines that are no {} statements; ignored", format),
                 firstOther_, others_);
}

}  // namespace rayscope::scene
