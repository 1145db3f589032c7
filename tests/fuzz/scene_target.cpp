#include <rayscope/diagnostics.h>

#include <algorithm>
#include <cctype>

#include "fuzz/memory_file.h"
#include "scene/toml/scene.h"

namespace rayscope::test {

namespace {

/// Whether the text may request a generated mesh or image that takes seconds to make: a number of four digits
/// or more beside the key `generate`.
bool isExpensive(std::string_view text) {
    if (text.find("generate") == std::string_view::npos) return false;
    int digits = 0;
    for (const char c : text) {
        digits = std::isdigit(static_cast<unsigned char>(c)) || c == '_' ? digits + 1 : 0;
        if (digits >= 4) return true;
    }
    return text.find("subdivisions") != std::string_view::npos;
}

/// A folder with a mesh and an image that scenes can name.
const MemoryFile& sceneFile() {
    static const MemoryFile file("fuzzed.toml");
    [[maybe_unused]] static const std::string others[]{
        file.folder().write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"),
        file.folder().write("t.pgm", "P5\n2 1\n255\nab")};
    return file;
}

}  // namespace

/// Any text gives a scene or InputError.
bool fuzzScene(FuzzInput input) {
    const std::string_view text = textOf(input);
    if (isExpensive(text)) return false;
    Diagnostics notes;
    try {
        const SceneDescription scene = scene::readTomlScene(sceneFile().path(), text, notes);
        for (const MeshInstance& mesh : scene.meshes)
            for (const std::uint32_t material : mesh.materials)
                require(material < scene.materials.size(), "meshes have materials that exist");
        for (const SphereInstance& sphere : scene.spheres)
            require(sphere.material < scene.materials.size(), "spheres have materials that exist");
        lint(scene);
        require(scene::titleOf(sceneFile().path(), text) == scene.title,
                "a title is read alone as with the scene");
    } catch (const InputError&) {
    }
    return true;
}

}  // namespace rayscope::test
