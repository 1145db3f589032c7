#pragma once

namespace rayscope::viewer {

/// How the rasterised view draws surfaces.
struct RasterStyle {
    bool smoothNormals = true;  ///< as the setting normal_interpolation
    bool textures = true;       ///< as the setting texture_mapping
    bool wireframe = false;
    bool operator==(const RasterStyle&) const = default;
};

}  // namespace rayscope::viewer
