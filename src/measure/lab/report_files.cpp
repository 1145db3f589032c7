// Writes the reports of a robustness test, and files that reproduce its failures.
#include <fmt/format.h>

#include <rayscope/lab.h>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/shell_quote.h"

namespace rayscope {

namespace {

/// Nine digits reproduce floats exactly.
std::string objOf(const MeshData& mesh) {
    std::string text = "# written by rayscope lab\n";
    for (const glm::vec3& v : mesh.positions) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
    for (const glm::uvec3& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
    return text;
}

/// A failure at the failing test point of a method that is nearest to the untransformed scene.
const LabFailure* nearestFailure(const LabResult& result, LabMethod method) {
    const LabFailure* nearest = nullptr;
    const auto distanceFromOriginal = [&](const LabFailure& f) {
        const LabTransform& transform = result.testPoints[f.testPoint].transform;
        return std::pair(std::abs(transform.scale), transform.offset);
    };
    for (const LabFailure& failure : result.failures)
        if (failure.method == method &&
            (!nearest || distanceFromOriginal(failure) < distanceFromOriginal(*nearest)))
            nearest = &failure;
    return nearest;
}

}  // namespace

std::vector<std::string> writeLab(const LabResult& result, const SceneDescription& scene,
                                  const std::string& folder) {
    const std::filesystem::path path(folder);
    base::writeFileAtomically((path / "lab.json").string(), labJson(result));
    base::writeFileAtomically((path / "lab.csv").string(), labCsv(result));
    base::writeFileAtomically((path / "lab.html").string(), labHtml(result));
    std::vector<std::string> commands;
    for (const LabMethod method : kLabMethods) {
        const LabFailure* first = nearestFailure(result, method);
        if (!first) continue;
        const std::string name = (path / infoOf(method).name).string();
        std::string rays;
        for (const LabFailure& failure : result.failures)
            if (failure.method == method && failure.testPoint == first->testPoint)
                rays.append(reinterpret_cast<const char*>(&failure.ray), sizeof(Ray));
        base::writeFileAtomically(name + ".obj",
                                  objOf(meshAt(scene, result.testPoints[first->testPoint].transform)));
        base::writeFileAtomically(name + ".rays", rays);
        commands.push_back(fmt::format("rayscope cast {} --rays {} -o {}", base::shellQuote(name + ".obj"),
                                       base::shellQuote(name + ".rays"), base::shellQuote(name + ".hits")));
    }
    return commands;
}

}  // namespace rayscope
