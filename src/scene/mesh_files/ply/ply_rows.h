#pragma once
// Readers of the rows of a PLY file, which follow its header.
#include "scene/load_step.h"
#include "scene/mesh_files/ply/ply_mesh.h"

namespace rayscope::scene {

/// What the readers of rows share. `input` is behind the header.
struct PlyRows {
    const std::string& path;
    base::BlockReader& input;
    const PlyPlan& plan;
    PlyMesh& mesh;
    Oddities& oddities;
    LoadStep& step;
};

/// Throw InputError, with the number of the row, at invalid indices and lengths of lists, and if the file
/// ends before its last element.
void readBinaryPly(const PlyRows& rows);

/// How the values of ASCII files are divided into rows: at line ends, where a line may hold more values than
/// its row, or by their number alone.
enum class PlyLayout { Lines, Words };

/// The lines do not agree with the rows that the header announces; reading with PlyLayout::Words may help.
struct PlyLayoutError {
    InputError error;
};

/// Throws InputError, with the line, at invalid numbers and indices, and if the file ends before its last
/// element; with PlyLayout::Lines also PlyLayoutError.
void readAsciiPly(const PlyRows& rows, PlyLayout layout);

/// The message about a file that ends after `row` rows of an element.
std::string endsEarly(const PlyElement& element, std::uint64_t row);

/// The message about an index that PlyMesh refuses.
std::string badVertexIndex(const PlyPlan& plan, std::int64_t index);

}  // namespace rayscope::scene
