// The results of a robustness test as text, JSON and CSV. Keys and column names are an interface for scripts
// and older than the names of the members.
#include <fmt/format.h>

#include <rayscope/lab.h>
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/printable_text.h"

namespace rayscope {

namespace {

nlohmann::json toJson(const LabCounts& c) {
    return {{"aimed", c.sharedEdgeRays},
            {"leaks", c.leaks},
            {"double_hits", c.doubleHits},
            {"spawned", c.spawned},
            {"false_hits", c.falseHits},
            {"second_surfaces", c.offsetSurfaceRays},
            {"lost_surfaces", c.missedSurfaces},
            {"t_error_over_bound", c.tRatio},
            {"weight_error_over_bound", c.weightRatio},
            {"sound", c.passed()}};
}

template <class Number>
nlohmann::json toJson(const std::optional<Number>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json toJson(const LabRange& r) {
    return {{"sound_as_it_is", r.soundUntransformed},
            {"lowest_scale", r.lowestScale},
            {"highest_scale", r.highestScale},
            {"first_failing_below", toJson(r.failsBelow)},
            {"first_failing_above", toJson(r.failsAbove)},
            {"largest_offset", r.largestOffset},
            {"first_failing_offset", toJson(r.failsBeyond)},
            {"failing_cells", r.failingTestPoints}};
}

nlohmann::json toJson(const Ray& r) {
    return {{"origin", {r.origin.x, r.origin.y, r.origin.z}},
            {"direction", {r.direction.x, r.direction.y, r.direction.z}}};
}

/// "passes from 2^-40 to 2^10 (2^20 fails) times its size, and up to 1e+07 sizes from the origin".
std::string rangeText(const LabRange& r) {
    if (!r.soundUntransformed) return "fails for the untransformed scene";
    const auto scale = [](int passed, const std::optional<int>& fails) {
        return fmt::format("2^{}{}", passed, fails ? fmt::format(" (2^{} fails)", *fails) : "");
    };
    return fmt::format("passes from {} to {} times its size, and up to {:g} sizes{} from the origin",
                       scale(r.lowestScale, r.failsBelow), scale(r.highestScale, r.failsAbove),
                       r.largestOffset, r.failsBeyond ? fmt::format(" ({:g} fail)", *r.failsBeyond) : "");
}

std::string ratioText(double ratio) {
    return ratio < 100.0 ? fmt::format("{:.3f}", ratio) : fmt::format("{:.1e}", ratio);
}

void appendRow(std::string& text, const std::string& name, const LabCounts& c) {
    text += fmt::format("{:<30} {:>9} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8} {:>9} {:>9}\n", name,
                        c.sharedEdgeRays, c.leaks, c.doubleHits, c.spawned, c.falseHits, c.offsetSurfaceRays,
                        c.missedSurfaces, ratioText(c.tRatio), ratioText(c.weightRatio));
}

void appendHeader(std::string& text, const std::string& first) {
    text += fmt::format("{:<30} {:>9} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8} {:>9} {:>9}\n", first, "at edges",
                        "leaks", "doubled", "spawned", "false", "surfaces", "lost", "t/bound", "uv/bound");
}

}  // namespace

std::string labText(const LabResult& r) {
    std::string text = fmt::format(
        "{}: {} triangles, {} shared edges, {} closed vertices; {:.4g} units large, {:.3g} sizes from the "
        "origin\n{} test points of {} rays in {:.1f} s\n\n",
        base::printable(r.scene), r.triangles, r.sharedEdges, r.closedVertices, r.size, r.offset,
        r.testPoints.size(), r.raysPerTestPoint + r.raysPerTestPoint / 2, r.seconds);
    appendHeader(text, "all test points");
    for (const LabMethod method : kLabMethods) appendRow(text, infoOf(method).label, r.total(method));
    text += "\n";
    appendHeader(text, "Rayscope, by scale and offset");
    for (const LabTestPoint& testPoint : r.testPoints)
        appendRow(text,
                  fmt::format("2^{:<3} {:>5g} sizes{}", testPoint.transform.scale, testPoint.transform.offset,
                              testPoint.degenerate ? fmt::format(" ({} flat)", testPoint.degenerate) : ""),
                  testPoint.of(LabMethod::Rayscope));
    text += "\nrange without failures for this scene\n";
    for (const LabMethod method : kLabMethods)
        text +=
            fmt::format("  {:<30} {}; {} of {} test points fail\n", infoOf(method).label,
                        rangeText(r.range(method)), r.range(method).failingTestPoints, r.testPoints.size());
    text += fmt::format("  {:<30} has no degenerate triangles up to an offset of {:g} sizes\n",
                        "the mesh in float", r.meshOffset);
    for (const std::string& remark : r.remarks) text += fmt::format("note: {}\n", remark);
    return text;
}

// Objects are created as such: if memory ends while the library turns a null into an object, it destroys what
// it has not created.
std::string labJson(const LabResult& r) {
    nlohmann::json testPoints = nlohmann::json::array(), failures = nlohmann::json::array(),
                   ranges = nlohmann::json::object(), totals = nlohmann::json::object();
    for (const LabTestPoint& testPoint : r.testPoints) {
        nlohmann::json methods = nlohmann::json::object();
        for (const LabMethod method : kLabMethods)
            methods[infoOf(method).name] = toJson(testPoint.of(method));
        testPoints.push_back({{"scale_exponent", testPoint.transform.scale},
                              {"offset_sizes", testPoint.transform.offset},
                              {"collapsed_triangles", testPoint.degenerate},
                              {"undecided", testPoint.undecided},
                              {"methods", methods}});
    }
    for (const LabMethod method : kLabMethods) {
        ranges[infoOf(method).name] = toJson(r.range(method));
        totals[infoOf(method).name] = toJson(r.total(method));
    }
    for (const LabFailure& f : r.failures)
        failures.push_back({{"cell", f.testPoint},
                            {"method", infoOf(f.method).name},
                            {"fault", nameOf(f.kind)},
                            {"ray", toJson(f.ray)}});
    const nlohmann::json all = {{"scene", r.scene},
                                {"triangles", r.triangles},
                                {"shared_edges", r.sharedEdges},
                                {"closed_vertices", r.closedVertices},
                                {"spheres_left_out", r.spheres},
                                {"size", r.size},
                                {"offset_sizes", r.offset},
                                {"rays_per_cell", r.raysPerTestPoint},
                                {"ranges", ranges},
                                {"totals", totals},
                                {"mesh_whole_to_offset", r.meshOffset},
                                {"cells", testPoints},
                                {"failures", failures},
                                {"remarks", r.remarks},
                                {"seconds", r.seconds},
                                {"interrupted", r.interrupted}};
    return base::jsonText(all);
}

std::string labCsv(const LabResult& r) {
    std::string text =
        "scale_exponent,offset_sizes,collapsed_triangles,undecided,method,aimed,leaks,double_hits,spawned,"
        "false_hits,second_surfaces,lost_surfaces,t_error_over_bound,weight_error_over_bound\n";
    for (const LabTestPoint& testPoint : r.testPoints)
        for (const LabMethod method : kLabMethods) {
            const LabCounts& c = testPoint.of(method);
            text += fmt::format("{},{:g},{},{},{},{},{},{},{},{},{},{},{:.6g},{:.6g}\n",
                                testPoint.transform.scale, testPoint.transform.offset, testPoint.degenerate,
                                testPoint.undecided, infoOf(method).name, c.sharedEdgeRays, c.leaks,
                                c.doubleHits, c.spawned, c.falseHits, c.offsetSurfaceRays, c.missedSurfaces,
                                c.tRatio, c.weightRatio);
        }
    return text;
}

}  // namespace rayscope
