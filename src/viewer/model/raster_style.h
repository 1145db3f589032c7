#pragma once

namespace rayscope::viewer {

/// What the raster view draws of surfaces.
struct RasterStyle {
    bool smoothNormals = true;
    bool textures = true;
    bool wireframe = false;
    bool operator==(const RasterStyle&) const = default;
};

}  // namespace rayscope::viewer
