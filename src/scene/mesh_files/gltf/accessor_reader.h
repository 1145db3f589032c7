#pragma once
#include <vector>

#include "scene/mesh_files/gltf/resources.h"

namespace rayscope::scene {

/// Reads the elements of accessors. All functions throw InputError, with the number of the accessor, if it
/// has another type than expected or exceeds its buffer view.
class GltfAccessorReader {
  public:
    /// The arguments must outlive the object.
    GltfAccessorReader(const std::string& path, const GltfDocument& document, GltfResources& resources)
        : path_(path), document_(document), resources_(resources) {}

    const GltfAccessor& accessor(std::uint32_t index) const { return document_.accessors[index]; }

    /// `components` values per element, which the accessor must have; normalized integers become 0 … 1 or
    /// −1 … 1.
    std::vector<float> floats(std::uint32_t index, std::uint32_t components);
    /// Scalars of an unsigned integer type.
    std::vector<std::uint32_t> indices(std::uint32_t index);

    /// Throws InputError with the number of the accessor.
    [[noreturn]] void fail(std::uint32_t index, const std::string& message) const;

  private:
    struct Elements {
        const std::byte* data = nullptr;
        std::size_t stride = 0, count = 0;
    };
    template <class Value>
    std::vector<Value> read(std::uint32_t index);
    Elements elements(std::uint32_t index, std::uint32_t view, std::uint64_t offset, std::uint64_t count,
                      std::size_t elementSize, bool strided);
    template <class Value>
    void readSparse(std::uint32_t index, std::vector<Value>& values);

    const std::string& path_;
    const GltfDocument& document_;
    GltfResources& resources_;
};

}  // namespace rayscope::scene
