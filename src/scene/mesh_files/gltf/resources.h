#pragma once
#include <rayscope/scene.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh_files/gltf/document.h"

namespace rayscope::scene {

using GltfBytes = std::span<const std::byte>;

/// The two parts of a glTF file; both refer to its bytes.
struct GltfContainer {
    std::string_view json{};
    std::optional<GltfBytes> binary{};  ///< the binary chunk of a GLB file
    bool isBinary = false;
};

/// Splits a GLB file into its chunks; a file without the signature of GLB is JSON. `path` is for messages.
/// Throws InputError if the file is empty, truncated or of another version.
GltfContainer splitGltfFile(std::string_view file, const std::string& path, Oddities& oddities);

/// An image of the document: a file, or bytes inside the document.
struct GltfImageSource {
    std::string path{};  ///< empty: `bytes`
    GltfBytes bytes{};
};

/// The buffers and images of a document, loaded when they are first used. All functions throw InputError with
/// the place in the document.
class GltfResources {
  public:
    /// The arguments must outlive the object.
    GltfResources(const std::string& path, const GltfContainer& container, const GltfDocument& document,
                  const LoadControl& control, Oddities& oddities);

    /// The bytes of a buffer view.
    GltfBytes view(std::uint32_t index);
    GltfImageSource image(std::uint32_t index);

    /// The bytes of the file and of the buffers loaded so far.
    std::uint64_t totalBytes() const { return totalBytes_; }

  private:
    GltfBytes buffer(std::uint32_t index);
    /// The path of the file that a URI names. Throws InputError unless it is a regular file.
    std::string resolve(const std::string& uri, const std::string& place) const;

    const std::string& path_;
    const GltfContainer& container_;
    const GltfDocument& document_;
    const LoadControl& control_;
    Oddities& oddities_;
    std::vector<std::optional<std::string>> buffers_, images_;
    std::uint64_t totalBytes_;
};

}  // namespace rayscope::scene
