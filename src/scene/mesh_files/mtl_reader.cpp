#include "scene/mesh_files/mtl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/mesh_files/tinyobj_tokenizer.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

class MtlReader {
  public:
    MtlReader(const std::string& path, TextureCache& textures, Diagnostics& notes)
        : path_(path), textures_(textures), notes_(notes) {}

    std::vector<Material> read() {
        const MtlContent content = tokenizeMtl(path_, readSource(path_));
        for (const MtlContent::OpacityConflict& conflict : content.opacityConflicts)
            note(Severity::Note,
                 fmt::format("material '{}': d {} contradicts Tr {}; d is used", conflict.material,
                             conflict.d, conflict.tr),
                 conflict.line);
        std::vector<Material> materials;
        for (const MtlMaterial& material : content.materials) materials.push_back(convert(material));
        if (!content.ignored.empty())
            note(Severity::Note, fmt::format("ignored statements: {}", fmt::join(content.ignored, ", ")));
        return materials;
    }

  private:
    void note(Severity severity, std::string message, int line = 0) {
        notes_.push_back({severity, std::move(message), {path_, line, 0}});
    }

    Material convert(const MtlMaterial& parsed) {
        Material material{.name = parsed.name,
                          .kd = parsed.kd,
                          .ks = parsed.ks,
                          .shininess = parsed.shininess,
                          .opacity = parsed.opacity,
                          .illum = parsed.illum};
        if (!(material.opacity >= 0.0f && material.opacity <= 1.0f)) {
            note(Severity::Warning, fmt::format("material '{}': d {} is not between 0 and 1; clamped",
                                                material.name, material.opacity));
            material.opacity = std::clamp(material.opacity, 0.0f, 1.0f);
        }
        if (!(material.shininess >= 0.0f)) {
            note(Severity::Warning, fmt::format("material '{}': Ns {} is negative; 0 is used", material.name,
                                                material.shininess));
            material.shininess = 0.0f;
        }
        if (!parsed.kdTexture.empty()) openTexture(parsed, material);
        return material;
    }

    void openTexture(const MtlMaterial& parsed, Material& material) {
        const std::string resolved = resolvePath(path_, parsed.kdTexture);
        try {
            material.kdTexture =
                textures_.open(resolved, parsed.clampsTexture ? TextureWrap::Clamp : TextureWrap::Repeat);
        } catch (const InputError& error) {
            if (!unreadable_.insert(resolved).second) return;
            note(Severity::Warning, fmt::format("material '{}': {}: {}; Kd is used instead", material.name,
                                                resolved, error.diagnostic().message));
        }
    }

    const std::string& path_;
    TextureCache& textures_;
    Diagnostics& notes_;
    std::set<std::string> unreadable_;
};

}  // namespace

std::vector<Material> readMtl(const std::string& path, TextureCache& textures, Diagnostics& notes) {
    return MtlReader(path, textures, notes).read();
}

}  // namespace rayscope::scene
