#include "scene/mesh_files/obj/mtl_reader.h"

#include <fmt/format.h>

#include <set>

#include "scene/load_step.h"
#include "scene/mesh_files/obj/mtl_parser.h"
#include "scene/mesh_files/obj/referenced_file.h"
#include "scene/mesh_files/text/text_file.h"

namespace rayscope::scene {

namespace {

class MtlReader {
  public:
    MtlReader(const std::string& path, const ImportContext& context)
        : path_(path), context_(context), oddities_(path) {}

    std::vector<Material> read() {
        const std::string text = readTextFile(path_, "MTL", oddities_, context_.control);
        const std::vector<ParsedMaterial> parsed = parseMtl(path_, text, oddities_);
        std::vector<MtlStatements> statements;
        statements.reserve(parsed.size());
        for (const ParsedMaterial& material : parsed) statements.push_back(material.statements);
        const std::vector<MtlValues> values = interpretMtl(statements);
        std::vector<Material> materials;
        LoadStep step(context_.control,
                      "loading the textures of " + path_.substr(path_.find_last_of('/') + 1), parsed.size());
        for (std::size_t i = 0; i < parsed.size(); ++i) {
            materials.push_back(convert(parsed[i], values[i]));
            step.advanceTo(i + 1);
        }
        for (const Problem* problem : {&missing_, &renamed_, &unreadable_}) report(*problem);
        oddities_.report(context_.notes);
        return materials;
    }

  private:
    Material convert(const ParsedMaterial& parsed, const MtlValues& values) {
        Material material{.name = parsed.name,
                          .kd = values.kd,
                          .ks = values.ks,
                          .shininess = values.shininess,
                          .opacity = values.opacity,
                          .illum = values.illum};
        if (material.opacity == 0.0f)
            oddities_.add(Severity::Warning,
                          fmt::format("materials are invisible by {}", parsed.statements.d ? "d 0" : "Tr 1"),
                          parsed.opacityLine);
        if (!parsed.texture.empty()) openTexture(parsed, material);
        if (!parsed.statements.kd && !material.kdTexture)
            oddities_.add(Severity::Note, fmt::format("materials without Kd; {} is used", values.kd.r),
                          parsed.line);
        return material;
    }

    void openTexture(const ParsedMaterial& parsed, Material& material) {
        const std::string name = referencedName(parsed.texture);
        const auto found = findReferenced(path_, parsed.texture);
        if (!found) {
            missing_.add(name, fmt::format("'{}' {}; Kd is used", name, whyNotFound(path_, parsed.texture)),
                         parsed.textureLine);
            return;
        }
        if (found->how != ReferencedFile::How::AsWritten)
            renamed_.add(name, fmt::format("'{}' is not found; {} is used", name, found->path),
                         parsed.textureLine);
        try {
            material.kdTexture = context_.textures.open(
                found->path, parsed.clampsTexture ? TextureWrap::Clamp : TextureWrap::Repeat);
        } catch (const InputError& error) {
            unreadable_.add(found->path,
                            fmt::format("{}: {}; Kd is used", found->path, error.diagnostic().message),
                            parsed.textureLine);
        }
    }

    /// Textures with the same problem: the message about the first, and which others there are.
    struct Problem {
        std::string firstMessage{};
        int firstLine = 0;
        std::set<std::string> files{};

        void add(const std::string& file, std::string message, int line) {
            if (files.empty()) {
                firstMessage = std::move(message);
                firstLine = line;
            }
            files.insert(file);
        }
    };
    void report(const Problem& problem) {
        if (problem.files.empty()) return;
        const std::size_t others = problem.files.size() - 1;
        const std::string more = others == 0   ? ""
                                 : others == 1 ? " (and 1 other texture)"
                                               : fmt::format(" (and {} other textures)", others);
        oddities_.add(Severity::Warning, "texture " + problem.firstMessage + more, problem.firstLine);
    }

    const std::string& path_;
    const ImportContext& context_;
    Oddities oddities_;
    Problem missing_, renamed_, unreadable_;
};

}  // namespace

std::vector<Material> readMtl(const std::string& path, const ImportContext& context) {
    return MtlReader(path, context).read();
}

}  // namespace rayscope::scene
