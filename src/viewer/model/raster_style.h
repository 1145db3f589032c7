#pragma once

namespace rayscope::viewer {

/// How the rasterised view draws surfaces.
struct RasterStyle {
    bool smoothNormals = true;
    bool textures = true;
    bool wireframe = false;
    bool operator==(const RasterStyle&) const = default;
};

}  // namespace rayscope::viewer
