#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Whether a file with this name is opened as a mesh file; the case of the suffix does not matter.
bool isMeshFileName(std::string_view path);

/// The suffixes of mesh files: ".obj" …
std::vector<std::string_view> meshFileSuffixes();

/// Reads a mesh file in any of the formats of isMeshFileName(). Throws InputError with the line, if the
/// format has lines, and Stopped. Notes and warnings are appended to `context.notes`.
ImportedMesh readMeshFile(const std::string& path, const ImportContext& context);

/// Appends a note if the file has cameras or lights, which a scene that uses its mesh does not have.
void noteCamerasAndLights(const ImportedMesh& mesh, const std::string& path, Diagnostics& notes);

}  // namespace rayscope::scene
