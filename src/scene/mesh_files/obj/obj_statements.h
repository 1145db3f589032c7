#pragma once
#include <array>
#include <string>
#include <string_view>

#include "scene/mesh_files/obj/skipped_statements.h"
#include "scene/oddities.h"

namespace rayscope::scene {

/// The statements of an OBJ file that make no triangles: groups, elements other than faces, free-form
/// geometry and whatever else stands in the file.
class ObjStatements {
  public:
    explicit ObjStatements(const std::string& path) : path_(path) {}

    void add(std::string_view keyword, std::string_view arguments, int line);
    /// A face with fewer than three corners.
    void addThinFace(int line) { thinFaces_.add(line); }

    /// `hasNormals`: without normals smoothing groups are noted, because other programs compute normals.
    void report(bool hasNormals, Oddities& oddities) const;

    /// Throws the InputError about a file without faces, which names what it has instead.
    [[noreturn]] void failWithoutFaces(std::size_t vertices) const;

  private:
    struct Count {
        std::size_t count = 0;
        int firstLine = 0;
        void add(int line) {
            if (count++ == 0) firstLine = line;
        }
    };
    const std::string& path_;
    Count thinFaces_, lines_, points_, freeForm_, smoothing_, others_;
    std::size_t groups_ = 0;
    std::string freeFormKeyword_;  ///< the most telling one
    SkippedStatements skipped_;
};

}  // namespace rayscope::scene
