#include "scene/mesh_files/obj/obj_materials.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>
#include <vector>

#include "base/lower_case.h"
#include "scene/mesh_files/obj/mtl_reader.h"
#include "scene/mesh_files/obj/referenced_file.h"
#include "scene/mesh_files/text/text_lines.h"

namespace rayscope::scene {

namespace {

std::string plainName(std::string_view name) { return std::string(unquoted(trimmed(withoutComment(name)))); }

std::string lowerCaseName(std::string_view name) { return base::lowerCase(plainName(name)); }

/// The file names in the arguments of mtllib, in which blanks separate names or belong to them: pieces that
/// end in quotes or in .mtl; without these, words.
std::vector<std::string_view> splitLibraries(std::string_view arguments) {
    std::vector<std::string_view> names;
    std::string_view left = trimmed(withoutComment(arguments));
    const auto take = [&](std::size_t length) {
        names.push_back(trimmed(left.substr(0, length)));
        left = trimmed(left.substr(length));
    };
    while (!left.empty()) {
        std::size_t end = std::string_view::npos;
        if (left.front() == '"') {
            end = left.find('"', 1);
        } else {
            const std::string lower = lowerCaseName(left);
            for (std::size_t at = lower.find(".mtl"); at != std::string::npos;
                 at = lower.find(".mtl", at + 1))
                if (at + 4 == lower.size() || isBlank(lower[at + 4])) {
                    end = at + 3;
                    break;
                }
        }
        if (end == std::string_view::npos) break;
        take(end + 1);
    }
    if (names.empty()) {
        Words words(left);
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) names.push_back(word);
    } else if (!left.empty()) {
        names.push_back(left);
    }
    return names;
}

/// Materials by name. Names are compared as written; then without comments and quotes; then without regard to
/// case.
class MaterialNames {
  public:
    void add(Material material) {
        for (std::size_t level = 0; level < kLevels; ++level)
            byName_[level].insert_or_assign(keyOf(material.name, level), materials_.size());
        materials_.push_back(std::move(material));
    }
    bool contains(const std::string& name) const { return byName_[0].contains(name); }

    /// Null if there is none. `level` is set to the number of ways that failed.
    const Material* find(const std::string& name, std::size_t& level) const {
        for (level = 0; level < kLevels; ++level)
            if (const auto found = byName_[level].find(keyOf(name, level)); found != byName_[level].end())
                return &materials_[found->second];
        return nullptr;
    }
    static constexpr std::size_t kIgnoringCase = 2;

  private:
    static constexpr std::size_t kLevels = 3;
    static std::string keyOf(const std::string& name, std::size_t level) {
        return level == 0 ? name : level == 1 ? plainName(name) : lowerCaseName(name);
    }
    std::vector<Material> materials_;
    std::array<std::map<std::string, std::size_t>, kLevels> byName_;
};

class MaterialLibrary {
  public:
    MaterialLibrary(const std::string& path, const ImportContext& context, Oddities& oddities)
        : path_(path), context_(context), oddities_(oddities) {}

    void open(const ParsedObj::Named& library) {
        if (plainName(library.name).empty())
            return oddities_.add(Severity::Warning, "mtllib without a file name; ignored", library.line);
        if (findAsWritten(library.name)) return openFile(library.name, library.line);
        for (const std::string_view name : splitLibraries(library.name)) openFile(name, library.line);
    }

    std::vector<Material> materialsOf(const std::vector<ParsedObj::Named>& slots) {
        std::vector<Material> list;
        std::vector<const ParsedObj::Named*> undefined;
        for (const ParsedObj::Named& slot : slots) {
            std::size_t level = 0;
            const Material* found = slot.line > 0 ? names_.find(slot.name, level) : nullptr;
            list.push_back(found ? *found : Material{});
            list.back().name = nameOf(slot);
            if (found && level == MaterialNames::kIgnoringCase)
                oddities_.add(Severity::Warning,
                              "materials (usemtl) whose names differ from those of the MTL file in upper and "
                              "lower case",
                              slot.line);
            if (!found && slot.line > 0 && !slot.name.empty()) undefined.push_back(&slot);
        }
        const std::string_view consequence =
            undefined.empty() ? "no material of it is used" : "default materials are used";
        for (const MissingLibrary& library : missing_)
            oddities_.add(Severity::Warning, fmt::format("{}; {}", library.problem, consequence),
                          library.line);
        if (!undefined.empty() && missing_.empty()) {
            const std::string others =
                undefined.size() > 1 ? fmt::format(" and {} more", undefined.size() - 1) : "";
            oddities_.add(Severity::Warning,
                          fmt::format("undefined material '{}'{}; a default material is used",
                                      undefined[0]->name, others),
                          undefined[0]->line);
        }
        return list;
    }

  private:
    /// A material file that cannot be read, and the line that names it.
    struct MissingLibrary {
        std::string problem;
        int line;
    };

    static std::string nameOf(const ParsedObj::Named& slot) {
        if (slot.line == 0) return "default";
        std::string name = plainName(slot.name);
        return name.empty() ? "unnamed" : name;
    }

    bool findAsWritten(std::string_view name) const {
        const auto found = findReferenced(path_, name);
        return found && found->how == ReferencedFile::How::AsWritten;
    }

    void openFile(std::string_view written, int line) {
        const auto found = findReferenced(path_, written);
        if (!found) {
            missing_.push_back(
                {fmt::format("material file '{}' {}", referencedName(written), whyNotFound(path_, written)),
                 line});
            return;
        }
        if (!opened_.insert(found->path).second) return;
        if (found->how != ReferencedFile::How::AsWritten)
            oddities_.add(Severity::Warning,
                          fmt::format("material file '{}' is not found; {} is used", referencedName(written),
                                      found->path),
                          line);
        try {
            for (Material& material : readMtl(found->path, context_)) {
                if (names_.contains(material.name))
                    oddities_.add(Severity::Warning,
                                  "materials in several MTL files; those of the last file are used", line);
                names_.add(std::move(material));
            }
        } catch (const InputError& error) {
            missing_.push_back(
                {fmt::format("material file {}: {}", found->path, error.diagnostic().message), line});
        }
    }

    const std::string& path_;
    const ImportContext& context_;
    Oddities& oddities_;
    MaterialNames names_;
    std::set<std::string> opened_;
    std::vector<MissingLibrary> missing_;
};

}  // namespace

std::vector<Material> readObjMaterials(const std::string& path, const ParsedObj& obj,
                                       const ImportContext& context) {
    Oddities oddities(path);
    MaterialLibrary library(path, context, oddities);
    for (const ParsedObj::Named& name : obj.libraries) library.open(name);
    std::vector<Material> materials = library.materialsOf(obj.slotNames);
    oddities.report(context.notes);
    return materials;
}

}  // namespace rayscope::scene
