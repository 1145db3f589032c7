#include <fmt/format.h>

#include <algorithm>

#include "base/parse_float.h"
#include "scene/mesh_files/stl/stl_facets.h"
#include "scene/mesh_files/text/word_reader.h"

namespace rayscope::scene {

namespace {

/// Compares without case; `lower` is in lower case.
bool isWord(std::string_view word, std::string_view lower) {
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

class StlAsciiReader {
  public:
    explicit StlAsciiReader(const StlInput& stl) : stl_(stl), words_(stl.path, stl.input, 1) {}

    void read() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (!isWord(word, "solid")) failExpecting("'solid'", word);
            beginSolid();
            readSolid();
        }
    }

  private:
    [[noreturn]] void failExpecting(std::string_view expected, std::string_view word) const {
        if (word.empty()) words_.fail(fmt::format("the file ends early: expected {}", expected));
        words_.fail(fmt::format("expected {}, got '{}'", expected, shown(word)));
    }
    void expect(std::string_view expected) {
        const std::string_view word = words_.next();
        if (!isWord(word, expected)) failExpecting(fmt::format("'{}'", expected), word);
    }

    void beginSolid() {
        if (++solids_ == 2)
            stl_.oddities.add(Severity::Note, "several solids are read as one mesh", words_.line());
        words_.skipLine();  // its name
    }

    void readSolid() {
        for (;;) {
            const std::string_view word = words_.next();
            if (isWord(word, "facet")) {
                readFacet();
            } else if (isWord(word, "endsolid")) {
                return words_.skipLine();
            } else if (isWord(word, "solid")) {
                stl_.oddities.add(Severity::Warning, "a solid begins before the 'endsolid' of the last one",
                                  words_.line());
                beginSolid();
            } else if (word.empty()) {
                return stl_.oddities.add(Severity::Warning, "the file ends without 'endsolid'",
                                         words_.line());
            } else {
                failExpecting("'facet' or 'endsolid'", word);
            }
        }
    }

    void readFacet() {
        const int line = words_.line();
        StlFacet facet{};
        std::string_view word = words_.next();
        if (isWord(word, "normal")) {
            facet.normal = readVector();
            word = words_.next();
        } else {
            stl_.oddities.add(Severity::Note, "facets without a normal", line);
        }
        if (!isWord(word, "outer")) failExpecting("'outer loop'", word);
        expect("loop");
        for (glm::vec3& corner : facet.corners) {
            expect("vertex");
            corner = readVector();
        }
        word = words_.next();
        if (isWord(word, "vertex")) words_.fail("a facet with more than three corners; expected 'endloop'");
        if (!isWord(word, "endloop")) failExpecting("'endloop'", word);
        expect("endfacet");
        stl_.facets.add(facet, line);
        stl_.step.advanceTo(words_.offset());
    }

    glm::vec3 readVector() {
        glm::vec3 vector;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = words_.next();
            const std::optional<float> value = base::parseFloat(word);
            if (!value)
                failExpecting(
                    word.find(',') == std::string_view::npos ? "a number" : "a number with a decimal point",
                    word);
            vector[i] = *value;
        }
        return vector;
    }

    const StlInput& stl_;
    WordReader words_;
    std::size_t solids_ = 0;
};

}  // namespace

void readAsciiStl(const StlInput& stl) { StlAsciiReader(stl).read(); }

}  // namespace rayscope::scene
