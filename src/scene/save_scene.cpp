#include <fmt/format.h>

#include <rayscope/save_scene.h>
#include <rayscope/settings.h>

#include <algorithm>
#include <filesystem>

#include "base/atomic_file.h"
#include "scene/mesh_files/read_mesh_file.h"
#include "scene/source_files.h"
#include "scene/toml/entries.h"
#include "scene/toml/field_texts.h"
#include "scene/toml/parse.h"
#include "scene/toml/text_edits.h"

namespace rayscope {

namespace {

using scene::Fields;
using scene::fieldsOf;
using scene::inlineText;
using scene::KeyText;
using scene::quotedText;
using scene::tableText;
using scene::TextEdits;

/// The cameras, lights and settings of a scene file.
struct Parts {
    std::vector<CameraDescription> cameras;
    std::vector<Light> lights;
    Fields settings;
};

template <class T>
bool areSame(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const T& x, const T& y) { return fieldsOf(x) == fieldsOf(y); });
}

std::string settingText(const toml::node& node) {
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
    if (const auto* real = node.as_floating_point()) return fmt::format("{}", real->get());
    const auto* word = node.as_string();
    return word ? word->get() : "";
}

Parts readParts(const std::string& path, const toml::table& root) {
    Parts parts;
    if (const toml::array* cameras = root["camera"].as_array())
        for (const toml::node& node : *cameras) {
            CameraDescription camera = scene::readCamera({path, node, "camera"});
            if (camera.name.empty())
                camera.name =
                    parts.cameras.empty() ? "main" : fmt::format("camera {}", parts.cameras.size() + 1);
            parts.cameras.push_back(std::move(camera));
        }
    if (const toml::array* lights = root["light"].as_array())
        for (const toml::node& node : *lights)
            parts.lights.push_back(scene::readLight({path, node, "light"}));
    if (const toml::table* settings = root["settings"].as_table())
        for (auto&& [key, value] : *settings)
            parts.settings.push_back({std::string(key.str()), settingText(value)});
    return parts;
}

/// Changes the fields of a table that differ.
void updateTable(TextEdits& edits, const toml::table& table, const Fields& before, const Fields& after) {
    if (before == after) return;
    if (table.is_inline()) return edits.replace(table, inlineText(after));
    for (const KeyText& field : after) {
        if (std::find(before.begin(), before.end(), field) != before.end()) continue;
        const toml::node* node = table.get(field.key);
        const toml::table* inner = node ? node->as_table() : nullptr;
        if (inner && !inner->is_inline()) {  // [camera.lens] or lens.f_number = …
            edits.removeLines(inner->source().begin.line, scene::lastLineOf(*inner));
            node = nullptr;
        }
        if (node)
            edits.replace(*node, field.value);
        else
            edits.insertBelow(table.source().end.line, field.key, field.value);
    }
    for (const KeyText& field : before) {
        const auto isSame = [&](const KeyText& other) { return other.key == field.key; };
        const toml::node* node = table.get(field.key);
        if (node && std::none_of(after.begin(), after.end(), isSame))
            edits.removeLines(node->source().begin.line, scene::lastLineOf(*node));
    }
}

/// Changes the tables of [[key]]. Equal ones at both ends keep their tables; between them they are assigned
/// in order.
template <class T>
void updateTables(TextEdits& edits, const toml::table& root, const std::string& key,
                  const std::vector<T>& before, const std::vector<T>& after) {
    if (areSame(before, after)) return;
    const std::string header = "[[" + key + "]]";
    const toml::array* array = root[key].as_array();
    if (array && (array->empty() || array->get(0)->as_table()->is_inline())) {
        std::vector<std::string> texts;
        for (const T& value : after) texts.push_back(inlineText(fieldsOf(value)));
        return edits.replace(*array, fmt::format("[{}]", fmt::join(texts, ", ")));
    }
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t tail = 0;
    if (before.size() > after.size())
        while (tail < shorter &&
               fieldsOf(before[before.size() - 1 - tail]) == fieldsOf(after[after.size() - 1 - tail]))
            ++tail;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const toml::table& table = *array->get(i)->as_table();
        const bool inTail = i >= before.size() - tail;
        const std::size_t to = inTail ? i + after.size() - before.size() : i;
        if (inTail || i < after.size() - tail)
            updateTable(edits, table, fieldsOf(before[i]), fieldsOf(after[to]));
        else
            edits.removeLines(table.source().begin.line, scene::lastLineOf(table));
    }
    for (std::size_t i = before.size(); i < after.size(); ++i)
        edits.append(tableText(header, fieldsOf(after[i])));
}

Fields settingFields(const SceneDescription& scene) {
    const std::vector<SettingInfo> known = describeSettings();
    Fields fields;
    for (const SettingAssignment& setting : scene.settings) {
        const auto info = std::find_if(known.begin(), known.end(),
                                       [&](const SettingInfo& i) { return i.key == setting.key; });
        const bool isWord = info != known.end() && info->kind == "choice";
        fields.push_back({setting.key, isWord ? quotedText(setting.value) : setting.value});
    }
    return fields;
}

void updateSettings(TextEdits& edits, const toml::table& root, const Fields& before,
                    const SceneDescription& scene) {
    Fields after = settingFields(scene), kept;
    const toml::table* table = root["settings"].as_table();
    if (!table) {
        if (!after.empty()) edits.append(tableText("[settings]", after));
        return;
    }
    // A value that is written in another way, 0.50 for 0.5, stays as it is.
    for (const KeyText& field : before) {
        const auto isSame = [&](const SettingAssignment& s) {
            return s.key == field.key && s.value == field.value;
        };
        const bool same = std::any_of(scene.settings.begin(), scene.settings.end(), isSame);
        const auto now =
            std::find_if(after.begin(), after.end(), [&](const KeyText& f) { return f.key == field.key; });
        kept.push_back(same ? *now : KeyText{field.key, ""});
    }
    const auto byKey = [](const KeyText& a, const KeyText& b) { return a.key < b.key; };
    std::sort(after.begin(), after.end(), byKey);
    std::sort(kept.begin(), kept.end(), byKey);
    updateTable(edits, *table, kept, after);
}

/// Replaces the names of files in `value` by names that are valid at the new path.
void moveReference(TextEdits& edits, const toml::node* value, const std::string& from,
                   const std::string& to) {
    const auto* name = value ? value->as_string() : nullptr;
    if (!name) return;
    const std::string target = scene::resolvePath(from, name->get());
    if (scene::resolvePath(to, name->get()) == target) return;
    edits.replace(*value, quotedText(target.starts_with("builtin:")
                                         ? target
                                         : std::filesystem::absolute(target).lexically_normal().string()));
}

void moveReferences(TextEdits& edits, const toml::table& root, const std::string& from,
                    const std::string& to) {
    if (const toml::array* meshes = root["mesh"].as_array())
        for (const toml::node& mesh : *meshes)
            if (mesh.is_table()) moveReference(edits, mesh.as_table()->get("file"), from, to);
    if (const toml::table* materials = root["material"].as_table())
        for (auto&& [name, material] : *materials) {
            const toml::node* texture =
                material.is_table() ? material.as_table()->get("kd_texture") : nullptr;
            if (texture && texture->is_table()) texture = texture->as_table()->get("file");
            moveReference(edits, texture, from, to);
        }
    const auto environment = root["environment"];
    moveReference(edits, environment["equirect"].node(), from, to);
    if (const toml::table* cube = environment["cube"].as_table())
        for (auto&& [face, file] : *cube) moveReference(edits, &file, from, to);
}

}  // namespace

std::string savedSceneText(const SceneDescription& scene, const std::string& path) {
    std::string from = scene.path, text = "version = 1\n";
    if (from.starts_with("builtin:")) from += ".toml";
    if (scene::isMeshFileName(from)) {
        text += fmt::format("\n[[mesh]]\nfile = {}\n", quotedText(from));
        if (std::any_of(scene.meshes.begin(), scene.meshes.end(),
                        [](const MeshInstance& mesh) { return mesh.vertexColors; }))
            text += "vertex_colors = true\n";
        from = (std::filesystem::current_path() / "scene.toml").string();
    } else {
        text = scene::readSource(from);
    }
    const toml::table root = scene::parseToml(from, text);
    const Parts before = readParts(from, root);
    TextEdits edits(text);
    updateTables(edits, root, "camera", before.cameras, scene.cameras);
    updateTables(edits, root, "light", before.lights, scene.lights);
    updateSettings(edits, root, before.settings, scene);
    moveReferences(edits, root, from, path);
    const std::string saved = edits.result();
    const Parts after = readParts(path, scene::parseToml(path, saved));
    Fields wanted;
    for (const SettingAssignment& setting : scene.settings) wanted.push_back({setting.key, setting.value});
    const auto byKey = [](const KeyText& a, const KeyText& b) { return a.key < b.key; };
    std::sort(wanted.begin(), wanted.end(), byKey);
    if (!areSame(after.cameras, scene.cameras) || !areSame(after.lights, scene.lights) ||
        after.settings != wanted)
        throw InputError(
            "cannot change this text so that it holds the edited scene; write its cameras and lights as "
            "[[camera]] and [[light]] with one key per line",
            {scene.path});
    return saved;
}

void saveScene(const SceneDescription& scene, const std::string& path) {
    base::writeFileAtomically(path, savedSceneText(scene, path));
}

}  // namespace rayscope
