#include "scene/mesh_files/gltf/node_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace rayscope::scene {

namespace {

/// An attribute of instances, empty if it is absent.
std::vector<float> instanceAttribute(const GltfNode& node, const char* name, std::uint32_t components,
                                     GltfAccessorReader& accessors) {
    const auto found = node.instances.find(name);
    if (found == node.instances.end()) return {};
    return accessors.floats(found->second, components);
}

}  // namespace

std::vector<glm::dmat4> instanceMatrices(const GltfDocument& document, const GltfPlacement& placement,
                                         GltfAccessorReader& accessors) {
    const GltfNode& node = document.nodes[placement.node];
    const std::vector<float> translations = instanceAttribute(node, "TRANSLATION", 3, accessors);
    const std::vector<float> rotations = instanceAttribute(node, "ROTATION", 4, accessors);
    const std::vector<float> scales = instanceAttribute(node, "SCALE", 3, accessors);
    const std::size_t count = std::max({translations.size() / 3, rotations.size() / 4, scales.size() / 3});
    if (count == 0) return {placement.toScene};
    std::vector<glm::dmat4> matrices;
    for (std::size_t i = 0; i < count; ++i) {
        glm::dmat4 matrix(1.0);
        if (4 * i < rotations.size()) {
            const float* q = &rotations[4 * i];
            matrix = glm::mat4_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
        }
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
            if (at < scales.size()) matrix[axis] *= static_cast<double>(scales[at]);
            if (at < translations.size()) matrix[3][axis] = static_cast<double>(translations[at]);
        }
        matrices.push_back(placement.toScene * matrix);
    }
    return matrices;
}

std::vector<glm::dmat4> jointMatrices(const GltfSkin& skin, const std::vector<glm::dmat4>& toScene,
                                      GltfAccessorReader& accessors) {
    std::vector<float> inverse;
    if (skin.inverseBindMatrices) {
        inverse = accessors.floats(*skin.inverseBindMatrices, 16);
        if (inverse.size() < 16 * skin.joints.size())
            accessors.fail(*skin.inverseBindMatrices,
                           fmt::format("expected {} matrices, one per joint, got {}", skin.joints.size(),
                                       inverse.size() / 16));
    }
    std::vector<glm::dmat4> matrices;
    for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
        glm::dmat4 bind(1.0);
        if (!inverse.empty())
            for (int i = 0; i < 16; ++i)
                bind[i / 4][i % 4] = static_cast<double>(inverse[16 * joint + static_cast<std::size_t>(i)]);
        matrices.push_back(toScene[skin.joints[joint]] * bind);
    }
    return matrices;
}

}  // namespace rayscope::scene
