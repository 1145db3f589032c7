#include "scene/mtl_reader.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

/// Kd as tinyobjloader leaves it when only map_Kd is given; kept as the colour behind a missing image.
Rgb colorOf(const tinyobj::real_t (&c)[3]) {
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

class MtlReader {
  public:
    MtlReader(const std::string& path, TextureCache& textures, Diagnostics& notes)
        : path_(path), textures_(textures), notes_(notes) {}

    std::vector<Material> read() {
        std::string content = readSource(path_);
        if (content.starts_with("\xef\xbb\xbf")) content.erase(0, 3);
        scan(content);
        std::istringstream stream(content);
        std::map<std::string, int> names;
        std::vector<tinyobj::material_t> parsed;
        std::string warning, error;
        tinyobj::LoadMtl(&names, &parsed, &stream, &warning, &error);
        if (!error.empty()) throw InputError(error, {path_});

        std::vector<Material> materials;
        for (const tinyobj::material_t& material : parsed)
            // The library begins with a nameless material when something stands before the first newmtl.
            if (!material.name.empty()) materials.push_back(convert(material));
        reportIgnored();
        return materials;
    }

  private:
    void note(Severity severity, std::string message, int line = 0) {
        notes_.push_back({severity, std::move(message), {path_, line, 0}});
    }

    /// What the library swallows: statements that mean nothing here, and d beside a Tr that says otherwise.
    void scan(const std::string& content) {
        static const std::set<std::string> known{"newmtl", "Kd", "Ks", "Ns", "d", "Tr", "illum", "map_Kd"};
        std::istringstream lines(content);
        std::string line, name;
        std::optional<float> d, tr;
        for (int number = 1; std::getline(lines, line); ++number) {
            std::istringstream words(line);
            words.imbue(std::locale::classic());
            std::string keyword;
            if (!(words >> keyword) || keyword.front() == '#') continue;
            if (!known.contains(keyword)) ignored_.insert(keyword);
            if (keyword == "newmtl") {
                words >> name;
                d = tr = {};
            }
            float value = 0.0f;
            if ((keyword != "d" && keyword != "Tr") || !(words >> value)) continue;
            (keyword == "d" ? d : tr) = value;
            if (d && tr && *d != 1.0f - *tr)
                note(Severity::Note,
                     fmt::format("material '{}': d {} and Tr {} contradict each other; d is used", name, *d,
                                 *tr),
                     number);
        }
    }

    Material convert(const tinyobj::material_t& parsed) {
        Material material{.name = parsed.name,
                          .kd = colorOf(parsed.diffuse),
                          .ks = colorOf(parsed.specular),
                          .shininess = static_cast<float>(parsed.shininess),
                          .opacity = static_cast<float>(parsed.dissolve),
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
        if (!parsed.diffuse_texname.empty()) openTexture(parsed, material);
        return material;
    }

    void openTexture(const tinyobj::material_t& parsed, Material& material) {
        const tinyobj::texture_option_t& options = parsed.diffuse_texopt;
        for (int axis = 0; axis < 2; ++axis)
            if (options.origin_offset[axis] != 0 || options.scale[axis] != 1) ignored_.insert("map_Kd -o/-s");
        const std::string resolved = resolvePath(path_, parsed.diffuse_texname);
        try {
            material.kdTexture =
                textures_.open(resolved, options.clamp ? TextureWrap::Clamp : TextureWrap::Repeat);
        } catch (const InputError& error) {
            if (!unreadable_.insert(resolved).second) return;
            note(Severity::Warning,
                 fmt::format("material '{}': {}; the colour Kd is used instead", material.name,
                             error.diagnostic().position.file.empty()
                                 ? error.diagnostic().message
                                 : fmt::format("{} {}", resolved, error.diagnostic().message)));
        }
    }

    void reportIgnored() {
        if (ignored_.empty()) return;
        note(Severity::Note, fmt::format("ignored: {}", fmt::join(ignored_, ", ")));
    }

    const std::string& path_;
    TextureCache& textures_;
    Diagnostics& notes_;
    std::set<std::string> ignored_, unreadable_;
};

}  // namespace

std::vector<Material> readMtl(const std::string& path, TextureCache& textures, Diagnostics& notes) {
    return MtlReader(path, textures, notes).read();
}

}  // namespace rayscope::scene
