#include "measure/trade/content_hash.h"

#include <fmt/format.h>

#include <cstring>
#include <span>

#include "sampling/hash.h"
#include "sampling/sample_stream.h"
#include "settings/table.h"
#include "trace/radiance.h"

namespace rayscope::measure {

namespace {

/// A 128-bit hash of a sequence of 8-byte words.
class Hasher {
  public:
    void bytes(const void* data, std::size_t size) {
        word(size);
        const auto* at = static_cast<const char*>(data);
        for (; size >= 8; size -= 8, at += 8) word(load(at, 8));
        if (size > 0) word(load(at, size));
    }
    template <class T>
    void array(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(values.data(), values.size() * sizeof(T));
    }
    template <class T>
    void value(const T& v) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
        bytes(&v, sizeof v);
    }
    void value(const glm::vec3& v) { bytes(&v, sizeof v); }
    void text(std::string_view t) { bytes(t.data(), t.size()); }
    std::string digits() const { return fmt::format("{:016x}{:016x}", a_, b_); }

  private:
    static std::uint64_t load(const char* at, std::size_t size) {
        std::uint64_t w = 0;
        std::memcpy(&w, at, size);
        return w;
    }
    void word(std::uint64_t w) {
        a_ = sampling::hashPair(a_, w);
        b_ = sampling::hashPair(w, b_);
    }
    std::uint64_t a_ = 1, b_ = 2;
};

void add(Hasher& hash, const std::shared_ptr<const Texture>& texture) {
    hash.value(texture != nullptr);
    if (!texture) return;
    hash.value(texture->wrap);
    hash.value(texture->image.width);
    hash.array(texture->image.pixels);
}

void add(Hasher& hash, const MeshInstance& mesh) {
    hash.array(mesh.data->positions);
    hash.array(mesh.data->normals);
    hash.array(mesh.data->texCoords);
    hash.array(mesh.data->triangles);
    hash.array(mesh.data->materialSlots);
    const glm::dmat4 matrix = matrixOf(mesh.transform);
    hash.bytes(&matrix, sizeof matrix);
    hash.array(mesh.materials);
    hash.value(mesh.motion);
    hash.value(mesh.vertexColors);
    if (mesh.vertexColors) hash.array(mesh.data->colors);
}

void add(Hasher& hash, const Material& material) {
    for (const Rgb& color : {material.kd, material.ks}) hash.value(color);
    hash.value(material.shininess);
    hash.value(material.opacity);
    hash.value(material.illum);
    add(hash, material.kdTexture);
}

void add(Hasher& hash, const Light& light) {
    hash.value(light.falloff);
    hash.value(light.shape.index());
    std::visit([&](const auto& shape) { hash.bytes(&shape, sizeof shape); }, light.shape);
}

void add(Hasher& hash, const CameraDescription& camera) {
    for (const glm::vec3& v : {camera.lookFrom, camera.lookAt, camera.up}) hash.value(v);
    hash.value(camera.fov);
    hash.value(camera.lens.has_value());
    if (!camera.lens) return;
    hash.value(camera.lens->fNumber);
    hash.value(camera.lens->focalLength);
    hash.value(camera.lens->focusDistance);
}

void add(Hasher& hash, const SceneDescription& scene) {
    hash.value(scene.meshes.size());
    for (const MeshInstance& mesh : scene.meshes) add(hash, mesh);
    for (const SphereInstance& sphere : scene.spheres) {
        hash.bytes(&sphere.sphere, sizeof sphere.sphere);
        hash.value(sphere.material);
        hash.value(sphere.motion);
    }
    hash.value(scene.materials.size());
    for (const Material& material : scene.materials) add(hash, material);
    hash.value(scene.lights.size());
    for (const Light& light : scene.lights) add(hash, light);
    hash.value(scene.environment != nullptr);
    if (!scene.environment) return;
    for (const auto& face : scene.environment->cube) add(hash, face);
    add(hash, scene.environment->equirect);
}

/// Traced samples: they change whenever the tracer does.
void addSamples(Hasher& hash, const trace::World& world) {
    trace::NullObserver observer;
    for (int i = 0; i < 64; ++i) {
        const auto random = sampling::hashPair(0, static_cast<std::uint64_t>(i));
        const SampleId sample{static_cast<int>(random % static_cast<std::uint64_t>(world.width)),
                              static_cast<int>((random >> 32) % static_cast<std::uint64_t>(world.height)), i};
        const RgbSum radiance = trace::radiance(world, 0, sample, observer).radiance;
        hash.bytes(&radiance, sizeof radiance);
    }
}

}  // namespace

std::string filmContentHash(const trace::CompileRequest& request, const trace::World& world) {
    Hasher hash;
    hash.value(request.width);
    hash.value(request.height);
    add(hash, request.camera);
    add(hash, *request.scene);
    settings::forEachSetting([&](const auto& row) {
        // Only a pattern that depends on the sample count makes spp part of the content.
        const bool isOnlyCount =
            row.text.key == "spp" && !sampling::dependsOnSampleCount(request.settings.sampler);
        if (row.invalidates >= Invalidates::Film && row.text.trade != Trade::Speed && !isOnlyCount)
            hash.text(textOf(request.settings, row.text.key));
    });
    addSamples(hash, world);
    return hash.digits();
}

std::string imageContentHash(const RgbImage& image) {
    Hasher hash;
    hash.array(image.pixels);
    return hash.digits();
}

}  // namespace rayscope::measure
