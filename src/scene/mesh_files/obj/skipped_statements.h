#pragma once
#include <set>
#include <string>
#include <string_view>

#include "scene/oddities.h"

namespace rayscope::scene {

/// Counts the statements of a text file that are not read, for one note. Only words that look like keywords
/// are quoted, so that a file that is something else, named by mistake or on purpose, is not printed.
class SkippedStatements {
  public:
    void add(std::string_view keyword, int line);

    /// `format`: e.g. "OBJ".
    void report(std::string_view format, Oddities& oddities) const;

  private:
    std::set<std::string, std::less<>> keywords_;
    bool isListFull_ = false;
    std::size_t others_ = 0;
    int firstOther_ = 0;
};

}  // namespace rayscope::scene
