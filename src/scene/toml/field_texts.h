#pragma once
#include <rayscope/scene.h>

#include <string>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// A key and its value as TOML text.
struct KeyText {
    std::string key, value;
    bool operator==(const KeyText&) const = default;
};
using Fields = std::vector<KeyText>;

/// All keys of a table of the scene file; equal if and only if the values have the same bits. The numbers are
/// the shortest that are read as the same float.
Fields fieldsOf(const Lens& lens);
Fields fieldsOf(const CameraDescription& camera);
Fields fieldsOf(const Light& light);

/// As a TOML string.
std::string quotedText(std::string_view text);
/// "{ key = value, … }".
std::string inlineText(const Fields& fields);
/// An empty line, the header, and a line per key.
std::string tableText(std::string_view header, const Fields& fields);

}  // namespace rayscope::scene
