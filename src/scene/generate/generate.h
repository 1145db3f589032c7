#pragma once
// Procedural meshes around the origin, Y up: triangles counter-clockwise seen from outside, unit normals, and
// texture coordinates for quads, boxes, UV spheres and tori. Shapes whose number of triangles is a parameter
// report their progress and throw Stopped.
#include <rayscope/scene.h>

namespace rayscope::scene {

/// A rectangle in the plane z = 0 that faces +z; two triangles.
struct QuadShape {
    glm::vec2 size{1.0f};
};
MeshData generate(const QuadShape& shape);

/// Twelve triangles with flat normals; each face has the whole texture.
struct BoxShape {
    glm::vec3 size{1.0f};
    bool inward = false;  ///< faces point inward, for rooms
};
MeshData generate(const BoxShape& shape);

/// A grid of latitude and longitude with poles on the y axis; 2 segments (rings − 1) triangles.
struct UvSphereShape {
    float radius = 1.0f;
    int segments = 64;
    int rings = 32;
};
MeshData generate(const UvSphereShape& shape, const LoadControl& control = {});

/// An icosahedron with each triangle split in four, `subdivisions` times: 20 · 4^subdivisions triangles.
struct IcosphereShape {
    float radius = 1.0f;
    int subdivisions = 3;
};
MeshData generate(const IcosphereShape& shape, const LoadControl& control = {});

/// A ring around the y axis; 2 segments · tubeSegments triangles.
struct TorusShape {
    float radius = 1.0f;
    float tubeRadius = 0.35f;
    int segments = 96;
    int tubeSegments = 48;
};
MeshData generate(const TorusShape& shape, const LoadControl& control = {});

/// Hills over the plane y = 0 by layered value noise; 2 cells[0] · cells[1] triangles.
struct TerrainShape {
    glm::vec2 size{2.0f, 2.0f};  ///< along x and z
    float height = 0.4f;         ///< upper bound of y
    int cellsX = 256;
    int cellsZ = 256;
    int seed = 1;
};
MeshData generate(const TerrainShape& shape, const LoadControl& control = {});

/// The Utah teapot (Newell 1975) in its own units with the bottom on y = 0, the spout along +x.
/// 16 gives 15,704 triangles.
struct TeapotShape {
    int resolution = 16;
};
MeshData generate(const TeapotShape& shape, const LoadControl& control = {});

/// A stylised monkey's head facing −z, with a radius of about 1: blended ellipsoids, polygonised on a grid.
/// Closed; 16 gives 960 triangles. At other resolutions an edge may have four triangles where a fold is
/// thinner than a grid cell.
struct MonkeyShape {
    int resolution = 16;
};
MeshData generate(const MonkeyShape& shape, const LoadControl& control = {});

/// A linear latitude-longitude image of a clear sky with a sun above a plain; the top row is up, the centre
/// is −z.
RgbImage generateSky(int width, int height);

}  // namespace rayscope::scene
