// Writes the reports of a robustness test, and files that reproduce its failures.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/lab.h>
#include <filesystem>
#include <optional>

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

/// Writes what can be written, although a file before it failed.
class FileWriter {
  public:
    void write(const std::string& path, const std::string& bytes) {
        try {
            base::writeFileAtomically(path, bytes);
        } catch (const InputError& error) {
            if (!firstError_) firstError_ = error;
        }
    }
    void throwFirstError() const {
        if (firstError_) throw *firstError_;
    }

  private:
    std::optional<InputError> firstError_;
};

}  // namespace

std::vector<std::string> writeLab(const LabResult& result, const SceneDescription& scene,
                                  const std::string& folder) {
    const std::filesystem::path path(folder);
    FileWriter files;
    files.write((path / "lab.json").string(), labJson(result));
    files.write((path / "lab.csv").string(), labCsv(result));
    files.write((path / "lab.html").string(), labHtml(result));
    std::vector<std::string> commands;
    for (const LabMethod method : kLabMethods) {
        const LabFailure* first = nearestFailure(result, method);
        if (!first) continue;
        const std::string name = (path / infoOf(method).name).string();
        std::string rays;
        for (const LabFailure& failure : result.failures)
            if (failure.method == method && failure.testPoint == first->testPoint)
                rays.append(reinterpret_cast<const char*>(&failure.ray), sizeof(Ray));
        files.write(name + ".obj", objOf(meshAt(scene, result.testPoints[first->testPoint].transform)));
        files.write(name + ".rays", rays);
        commands.push_back(
            fmt::format("rayscope cast {} --rays {} -o {}", base::shellQuotePath(name + ".obj"),
                        base::shellQuotePath(name + ".rays"), base::shellQuotePath(name + ".hits")));
    }
    files.throwFirstError();
    return commands;
}

}  // namespace rayscope
