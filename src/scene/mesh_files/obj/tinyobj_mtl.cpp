#include "scene/mesh_files/obj/tinyobj_mtl.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace rayscope::scene {

namespace {

/// With 17 digits, because the library rounds several times: its result then lies so close to the float that
/// it is rounded to it.
std::string textOf(float value) { return fmt::format("{:.17g}", static_cast<double>(value)); }

std::string textOf(const Rgb& color) {
    return fmt::format("{} {} {}", textOf(color.r), textOf(color.g), textOf(color.b));
}

/// Materials per call, because those of the library take 2 KB each.
constexpr std::size_t kBlock = 1024;

/// The default of this program for materials without Kd; that of the library is black.
constexpr Rgb kDefaultKd(0.8f);

std::string textOf(std::span<const MtlStatements> materials) {
    std::string text;
    const auto line = [&](std::string_view keyword, const std::string& value) {
        text += fmt::format("{} {}\n", keyword, value);
    };
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const MtlStatements& m = materials[i];
        line("newmtl", std::to_string(i));
        line("Kd", textOf(m.kd.value_or(kDefaultKd)));
        if (m.ks) line("Ks", textOf(*m.ks));
        if (m.ns) line("Ns", textOf(*m.ns));
        if (m.d) line("d", textOf(*m.d));
        if (m.tr) line("Tr", textOf(*m.tr));
        line("illum", std::to_string(m.illum.value_or(-1)));
    }
    return text;
}

Rgb colorOf(const tinyobj::real_t (&c)[3]) {
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

}  // namespace

std::vector<MtlValues> interpretMtl(std::span<const MtlStatements> materials) {
    std::vector<MtlValues> values;
    while (!materials.empty()) {
        const std::size_t count = std::min(materials.size(), kBlock);
        std::istringstream stream(textOf(materials.first(count)));
        materials = materials.subspan(count);
        std::map<std::string, int> names;
        std::vector<tinyobj::material_t> parsed;
        std::string warning, error;
        tinyobj::LoadMtl(&names, &parsed, &stream, &warning, &error);
        for (const tinyobj::material_t& material : parsed)
            values.push_back({.kd = colorOf(material.diffuse),
                              .ks = colorOf(material.specular),
                              .shininess = static_cast<float>(material.shininess),
                              .opacity = static_cast<float>(material.dissolve),
                              .illum = material.illum});
    }
    return values;
}

}  // namespace rayscope::scene
