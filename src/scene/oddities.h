#pragma once
#include <rayscope/diagnostics.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// Collects what is odd about a file, so that each kind is reported once, with its count and its first line.
class Oddities {
  public:
    /// Kinds beyond are counted together, because a file may hold a kind per line: a name that is not found.
    static constexpr std::size_t kMostKinds = 50;

    explicit Oddities(std::string path) : path_(std::move(path)) {}

    /// `kind` is the message in the singular or with its count left out, e.g. "normals that do not exist;
    /// ignored". It is also the identity of the kind. `line` 0: the format has no lines.
    /// Nothing is added if `count` is 0.
    void add(Severity severity, std::string_view kind, int line = 0, std::size_t count = 1);

    /// Appends one message per kind in the order of their first occurrences: "file:line: warning: KIND", with
    /// "(N times, first here)" behind those that occurred more than once; then one for those beyond
    /// kMostKinds.
    void report(Diagnostics& notes) const;

    /// The first kinds as an appendix to the error about a file in which nothing usable is left: "; " and the
    /// text of each, without counts. Empty if there are none.
    std::string appendix() const;

  private:
    struct Kind {
        Severity severity;
        std::string text;
        int firstLine;
        std::size_t count;
    };
    std::string path_;
    std::vector<Kind> kinds_;
    Kind others_{Severity::Note, {}, 0, 0};
};

}  // namespace rayscope::scene
