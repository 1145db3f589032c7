#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// A corner of a face as written: indices from 1, or negative ones that count back from the last element.
/// Values beyond 64 bits become the largest one. An index that is left out has no value; "1//" and "1/" leave
/// out the texture coordinate and the normal.
struct WrittenCorner {
    std::int64_t position = 0;
    std::optional<std::int64_t> texCoord, normal;
};

/// Parses position[/[texCoord][/[normal]]], each an integer with an optional sign. False if the word is
/// anything else.
bool parseCorner(std::string_view word, WrittenCorner& corner);

/// What is wrong with a word that parseCorner() refuses, for a message.
std::string cornerError(std::string_view word);

}  // namespace rayscope::scene
