#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// The positive indices of one kind that were beyond the elements so far. Later elements may make them valid,
/// so only those that exceed all earlier ones are kept: the first invalid one is among them.
class ForwardReferences {
  public:
    struct Reference {
        std::int64_t index;
        int line, column;
    };
    bool exceeds(std::int64_t index) const { return references_.empty() || index > references_.back().index; }
    void add(std::int64_t index, int line, int column) { references_.push_back({index, line, column}); }
    /// The first index above `count`; null: none.
    const Reference* firstBeyond(std::size_t count) const {
        const auto found = std::upper_bound(
            references_.begin(), references_.end(), static_cast<std::int64_t>(count),
            [](std::int64_t value, const Reference& reference) { return value < reference.index; });
        return found == references_.end() ? nullptr : &*found;
    }

  private:
    std::vector<Reference> references_;
};

/// Corners with a texture coordinate or a normal that does not exist.
struct MissingElements {
    std::string_view what;
    std::size_t count = 0;
    int firstLine = 0;
    void add(int line) {
        if (count++ == 0 || line < firstLine) firstLine = line;
    }
};

/// References to texture coordinates or to normals.
struct OptionalReferences {
    ForwardReferences forward;
    MissingElements missing;
};

}  // namespace rayscope::scene
