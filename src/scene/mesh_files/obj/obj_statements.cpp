#include "scene/mesh_files/obj/obj_statements.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::scene {

namespace {

using namespace std::string_view_literals;

/// Those that make geometry; the others describe it.
constexpr std::array kFreeFormElements{"curv"sv, "curv2"sv, "surf"sv, "bzp"sv, "bsp"sv, "cdc"sv, "cdp"sv};
constexpr std::array kFreeFormOthers{"vp"sv,   "cstype"sv, "deg"sv,  "bmat"sv,  "step"sv,
                                     "parm"sv, "trim"sv,   "hole"sv, "scrv"sv,  "sp"sv,
                                     "end"sv,  "con"sv,    "res"sv,  "stech"sv, "ctech"sv};

template <class List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

void ObjStatements::add(std::string_view keyword, std::string_view arguments, int line) {
    if (keyword == "o" || keyword == "g") {
        ++groups_;
    } else if (keyword == "s") {
        if (arguments != "off" && arguments != "0" && arguments != "null") smoothing_.add(line);
    } else if (keyword == "l") {
        lines_.add(line);
    } else if (keyword == "p") {
        points_.add(line);
    } else if (const bool isElement = contains(kFreeFormElements, keyword);
               isElement || contains(kFreeFormOthers, keyword)) {
        freeForm_.add(line);
        if (freeFormKeyword_.empty() || (isElement && !contains(kFreeFormElements, freeFormKeyword_)))
            freeFormKeyword_ = keyword;
    } else {
        others_.add(line);
        skipped_.add(keyword, line);
    }
}

void ObjStatements::report(bool hasNormals, Oddities& oddities) const {
    oddities.add(Severity::Note, "faces with fewer than three corners; ignored", thinFaces_.firstLine,
                 thinFaces_.count);
    oddities.add(Severity::Note, "line elements (l); ignored", lines_.firstLine, lines_.count);
    oddities.add(Severity::Note, "point elements (p); ignored", points_.firstLine, points_.count);
    oddities.add(Severity::Warning, "statements of free-form curves and surfaces; ignored",
                 freeForm_.firstLine, freeForm_.count);
    if (!hasNormals && smoothing_.count > 0)
        oddities.add(Severity::Note,
                     "smoothing groups (s) are ignored: the file has no normals (vn), so its faces are flat",
                     smoothing_.firstLine);
    skipped_.report("OBJ", oddities);
}

void ObjStatements::failWithoutFaces(std::size_t vertices) const {
    std::string reason;
    if (freeForm_.count > 0)
        reason =
            fmt::format("; its free-form curves and surfaces ({} in line {}) are not read, export polygons",
                        freeFormKeyword_, freeForm_.firstLine);
    else if (thinFaces_.count > 0)
        reason = fmt::format(" with three or more corners; the first of its {} others is in line {}",
                             thinFaces_.count, thinFaces_.firstLine);
    else if (lines_.count > 0)
        reason = fmt::format("; it has {} line elements (l)", lines_.count);
    else if (points_.count > 0)
        reason = fmt::format("; it has {} point elements (p)", points_.count);
    else if (vertices > 0)
        reason = fmt::format("; it has only {} vertices", vertices);
    else if (others_.count > 0 && groups_ == 0)
        reason = "; none of its lines is a statement of an OBJ file";
    throw InputError("the file has no faces (lines 'f …')" + reason, {path_});
}

}  // namespace rayscope::scene
