#pragma once
#include <rayscope/scene.h>

namespace rayscope::scene {

/// The parts of checkDescription() whose time does not depend on the number of triangles: pointers, and
/// indices of materials.
void checkReferences(const SceneDescription& scene);

/// The part of checkDescription() about the material slots of one mesh, whose data must not be null.
void checkSlots(const MeshInstance& mesh);

}  // namespace rayscope::scene
