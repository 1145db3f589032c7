#include "scene/toml/scene.h"

#include <rayscope/settings.h>

#include <map>
#include <set>

#include "scene/environment_shape.h"
#include "scene/generate/generate.h"
#include "scene/load_step.h"
#include "scene/mesh_files/read_mesh_file.h"
#include "scene/missing_content.h"
#include "scene/source_files.h"
#include "scene/textures.h"
#include "scene/toml/entries.h"
#include "scene/toml/parse.h"

namespace rayscope::scene {

namespace {

constexpr std::array<std::string_view, 9> kSceneKeys{"version",  "title", "camera",      "mesh",    "sphere",
                                                     "material", "light", "environment", "settings"};

/// Builds the description from the entries of one file: resolves names, loads files, collects notes.
class SceneBuilder {
  public:
    SceneBuilder(const std::string& path, const toml::table& root, Diagnostics& notes,
                 const LoadControl& control)
        : path_(path), root_(root), notes_(notes), control_(control) {}

    SceneDescription build() {
        scene_.path = path_;
        checkKeys(path_, root_, "a scene", kSceneKeys);
        readHead();
        readMaterials();
        forEachOf("camera", [&](const TomlValue& value) { addCamera(value); });
        forEachOf("light", [&](const TomlValue& value) { scene_.lights.push_back(readLight(value)); });
        readSettings();
        readEnvironmentTable();
        addMeshes();
        forEachOf("sphere", [&](const TomlValue& value) { addSphere(value); });
        checkCompleteness();
        return std::move(scene_);
    }

  private:
    void note(Severity severity, std::string message, SourcePosition position) {
        notes_.push_back({severity, std::move(message), std::move(position)});
    }

    /// Calls visit for each table of [[key]].
    template <class Visit>
    void forEachOf(std::string_view key, const Visit& visit) {
        const toml::node* node = root_.get(key);
        if (!node) return;
        const toml::array* tables = node->as_array();
        if (!tables)
            TomlValue{path_, *node, key}.fail(fmt::format("expected an array of tables; write [[{}]]", key));
        LoadStep step(control_, fmt::format("reading [[{}]]", key), tables->size());
        for (const toml::node& element : *tables) {
            visit(TomlValue{path_, element, key});
            step.advance();
        }
    }

    void readHead() {
        const toml::node* version = root_.get("version");
        if (!version) throw InputError("a scene needs the key 'version'; write version = 1", {path_, 1, 1});
        readInteger({path_, *version, "version"}, 1, 1);
        if (const toml::node* title = root_.get("title")) scene_.title = readText({path_, *title, "title"});
    }

    void readMaterials() {
        const toml::node* node = root_.get("material");
        if (!node) return;
        if (!node->is_table())
            TomlValue{path_, *node, "material"}.fail("expected a table; write [material.NAME]");
        for (auto&& [name, body] : *node->as_table()) {
            const TomlValue value{path_, body, name.str()};
            if (name.str().empty())
                throw InputError("a material needs a name; write [material.NAME]",
                                 positionIn(path_, name.source()));
            if (!body.is_table()) value.fail("expected a table; write [material.NAME]");
            MaterialEntry entry = readMaterial(value);
            if (entry.texture) entry.material.kdTexture = textureOf(*entry.texture);
            materialIndices_[entry.material.name] = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back(std::move(entry.material));
        }
    }

    std::shared_ptr<const Texture> textureOf(TextureEntry& entry) {
        if (!entry.image.empty())
            return std::make_shared<Texture>(Texture{"generated", std::move(entry.image), entry.wrap});
        return openTexture(entry.file, entry.wrap);
    }

    std::shared_ptr<const Texture> openTexture(const LocatedText& file, TextureWrap wrap) {
        const std::string resolved = resolvePath(path_, file.text);
        if (!fileExists(resolved))
            throw InputError(fmt::format("image file not found: {}", resolved), file.position);
        return textures_.open(resolved, wrap);
    }

    std::uint32_t materialOf(const std::optional<LocatedText>& name) {
        if (!name) return defaultMaterial();
        if (const auto found = materialIndices_.find(name->text); found != materialIndices_.end())
            return found->second;
        std::vector<std::string_view> known;
        for (const auto& [key, index] : materialIndices_) known.push_back(key);
        const std::string choices = known.empty() ? "the scene defines no material"
                                                  : fmt::format("expected {}", base::joinChoices(known));
        throw InputError(fmt::format("undefined material '{}'{}; {}", name->text,
                                     base::didYouMean(name->text, known), choices),
                         name->position);
    }

    /// The material of objects without a material.
    std::uint32_t defaultMaterial() {
        if (!default_) {
            default_ = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back({.name = "default"});
        }
        return *default_;
    }

    void addCamera(const TomlValue& value) {
        CameraDescription camera = readCamera(value);
        if (camera.name.empty())
            camera.name =
                scene_.cameras.empty() ? "main" : fmt::format("camera {}", scene_.cameras.size() + 1);
        if (!cameraNames_.insert(camera.name).second)
            value.fail(fmt::format("duplicate camera name '{}'", camera.name));
        scene_.cameras.push_back(std::move(camera));
    }

    /// The tables are read before the files, because instances of a file decide together whether its vertex
    /// colours are stored.
    void addMeshes() {
        std::vector<MeshEntry> entries;
        forEachOf("mesh", [&](const TomlValue& value) { entries.push_back(readMesh(value)); });
        for (const MeshEntry& entry : entries)
            if (entry.file && entry.instance.vertexColors)
                coloredFiles_.insert(resolvePath(path_, entry.file->text));
        for (std::size_t i = 0; i < entries.size(); ++i)
            addMesh(entries[i], withPrefix(control_, fmt::format("mesh {} of {}", i + 1, entries.size())));
    }

    void addMesh(MeshEntry& entry, const LoadControl& control) {
        MeshInstance& mesh = entry.instance;
        if (entry.file) {
            loadMesh(entry, control);
        } else {
            mesh.materials = {materialOf(entry.material)};
            mesh.data = std::make_shared<MeshData>(entry.generate(control));
        }
        if (mesh.name.empty()) mesh.name = fmt::format("mesh {}", scene_.meshes.size() + 1);
        if (mesh.vertexColors && mesh.data->colors.empty())
            note(Severity::Warning,
                 fmt::format("mesh '{}' has no vertex colours; its materials are shown", mesh.name),
                 entry.vertexColors);
        scene_.meshes.push_back(std::move(mesh));
    }

    void loadMesh(MeshEntry& entry, const LoadControl& control) {
        const std::string resolved = resolvePath(path_, entry.file->text);
        if (!fileExists(resolved)) {
            const std::string hint = entry.ifMissing.empty() ? "" : fmt::format("; {}", entry.ifMissing);
            throw InputError(fmt::format("mesh file not found: {}{}", resolved, hint), entry.file->position);
        }
        // Instances of the same file share its data.
        auto& loaded = meshes_[resolved];
        if (!loaded) {
            loaded = std::make_shared<ImportedMesh>(
                readMeshFile(resolved, {textures_, notes_, control, coloredFiles_.contains(resolved)}));
            noteCamerasAndLights(*loaded, resolved, notes_);
        }
        MeshInstance& mesh = entry.instance;
        mesh.data = loaded->data;
        if (mesh.name.empty()) mesh.name = entry.file->text;
        if (entry.material) {
            mesh.materials.assign(loaded->materials.size(), materialOf(entry.material));
            return;
        }
        auto& first = firstMaterialOf_[resolved];
        if (!first) {
            first = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.insert(scene_.materials.end(), loaded->materials.begin(),
                                    loaded->materials.end());
        }
        for (std::size_t slot = 0; slot < loaded->materials.size(); ++slot)
            mesh.materials.push_back(*first + static_cast<std::uint32_t>(slot));
    }

    void addSphere(const TomlValue& value) {
        SphereEntry entry = readSphere(value);
        entry.instance.material = materialOf(entry.material);
        if (entry.instance.name.empty())
            entry.instance.name = fmt::format("sphere {}", scene_.spheres.size() + 1);
        scene_.spheres.push_back(std::move(entry.instance));
    }

    void readEnvironmentTable() {
        const toml::node* node = root_.get("environment");
        if (!node) return;
        const EnvironmentEntry entry = readEnvironment({path_, *node, "environment"});
        auto environment = std::make_shared<Environment>();
        if (entry.sky)
            environment->equirect = std::make_shared<Texture>(Texture{"generated", generateSky(1024, 512)});
        else if (!entry.equirect.text.empty())
            environment->equirect = openTexture(entry.equirect, TextureWrap::Repeat);
        else
            for (std::size_t face = 0; face < environment->cube.size(); ++face)
                environment->cube[face] = openTexture(entry.cube[face], TextureWrap::Clamp);
        for (std::string& oddity : environmentOddities(*environment))
            note(Severity::Warning, std::move(oddity), positionIn(path_, node->source()));
        scene_.environment = std::move(environment);
    }

    void readSettings() {
        const toml::node* node = root_.get("settings");
        if (!node) return;
        Settings scratch;
        const std::vector<SettingInfo> known = describeSettings();
        for (auto&& [key, body] : readTable({path_, *node, "settings"})) {
            const TomlValue value{path_, body, key.str()};
            const SourcePosition position = positionIn(path_, key.source());
            const std::string_view name = key.str();
            const auto info =
                std::find_if(known.begin(), known.end(), [&](const SettingInfo& i) { return i.key == name; });
            const std::string text = settingText(value, info == known.end() ? nullptr : &*info);
            try {
                assign(scratch, name, text);
            } catch (const InputError& error) {
                throw InputError(error.diagnostic().message, position);
            }
            scene_.settings.push_back({std::string(name), text, position});
        }
    }

    /// The value as written on the command line. `info` is null for an unknown setting.
    static std::string settingText(const TomlValue& value, const SettingInfo* info) {
        const auto& node = value.node;
        if (info && info->kind == "boolean" && !node.is_boolean()) value.failType("true or false");
        if (info && info->kind == "integer" && !node.is_integer()) value.failType("an integer");
        if (info && info->kind == "number" && !node.is_number()) value.failType("a number");
        if (info && info->kind == "choice" && !node.is_string())
            value.failType(base::joinChoices(info->choices));
        if (value.node.is_boolean()) return readBoolean(value) ? "true" : "false";
        if (value.node.is_integer()) return fmt::format("{}", value.node.as_integer()->get());
        if (value.node.is_floating_point()) return fmt::format("{}", value.node.as_floating_point()->get());
        if (value.node.is_string()) return readText(value);
        value.failType("true, false, a number or a name");
    }

    /// Adds a default camera, and warnings about missing entries.
    void checkCompleteness() {
        if (scene_.cameras.empty()) {
            note(Severity::Warning, "no camera: a default one shows the whole scene; add [[camera]]",
                 {path_});
            scene_.cameras.push_back(framingCamera(boundsOf(scene_, control_)));
        }
        for (Diagnostic& missing : missingContent(scene_)) notes_.push_back(std::move(missing));
    }

    const std::string& path_;
    const toml::table& root_;
    Diagnostics& notes_;
    const LoadControl& control_;
    SceneDescription scene_;
    TextureCache textures_{notes_, control_};
    std::map<std::string, std::uint32_t> materialIndices_;
    std::set<std::string> cameraNames_;
    std::optional<std::uint32_t> default_;
    std::map<std::string, std::shared_ptr<ImportedMesh>> meshes_;
    std::set<std::string> coloredFiles_;  ///< mesh files whose vertex colours some instance shows
    std::map<std::string, std::optional<std::uint32_t>> firstMaterialOf_;
};

}  // namespace

SceneDescription readTomlScene(const std::string& path, std::string_view text, Diagnostics& notes,
                               const LoadControl& control) {
    const toml::table root = parseToml(path, text, control);
    return SceneBuilder(path, root, notes, control).build();
}

std::string titleOf(const std::string& path, std::string_view text) {
    const toml::table root = parseToml(path, text);
    const toml::node* title = root.get("title");
    return title ? readText({path, *title, "title"}) : std::string{};
}

}  // namespace rayscope::scene
