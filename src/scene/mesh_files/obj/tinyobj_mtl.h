#pragma once
// tinyobjloader as the interpreter of MTL files: what defaults a material has, and which of d and Tr counts.
// Only this file includes the library. It gets statements that were checked before, because by itself it
// reads a word in place of a number as 0, "nan" as 0, "Kd 0.5" as red, "d -halo 0.5" as 0 and options of
// textures with fewer values than it expects as part of the name, all without a message.
#include <rayscope/vector.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rayscope::scene {

/// The statements of one material that have an effect; values are finite and in range.
struct MtlStatements {
    std::optional<Rgb> kd, ks;  ///< 0 … 1
    std::optional<float> ns, d, tr;
    std::optional<int> illum;
};

/// The values that a material has according to its statements.
struct MtlValues {
    Rgb kd, ks;
    float shininess, opacity;
    int illum;  ///< −1: not given
};

/// One element per material, in the same order.
std::vector<MtlValues> interpretMtl(std::span<const MtlStatements> materials);

}  // namespace rayscope::scene
