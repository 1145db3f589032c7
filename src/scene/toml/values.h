#pragma once
// Strict readers of TOML values. All throw InputError, at the position of the value, if the type or range is
// wrong.
#include <rayscope/diagnostics.h>
#include <rayscope/vector.h>
#include <toml++/toml.h>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// The range of a number. Both ends are included unless open.
struct NumberRange {
    double lowest = -std::numeric_limits<float>::max();
    double highest = std::numeric_limits<float>::max();
    bool openLow = false;
    bool openHigh = false;

    bool contains(double x) const {
        return (openLow ? x > lowest : x >= lowest) && (openHigh ? x < highest : x <= highest);
    }
    /// " from 0 to 1", " above 0", … or "" for kAnyNumber.
    std::string text() const;
};
inline constexpr NumberRange kAnyNumber{};
inline constexpr NumberRange kFraction{.lowest = 0.0, .highest = 1.0};
inline constexpr NumberRange kNonNegative{.lowest = 0.0};
inline constexpr NumberRange kPositive{.lowest = 0.0, .openLow = true};

/// One value of the file, and its key for messages.
struct TomlValue {
    const std::string& file;
    const toml::node& node;
    std::string_view key;

    SourcePosition position() const;
    /// Throws "key: message" at the position of the value.
    [[noreturn]] void fail(std::string_view message) const;
    /// Throws "key: expected …, got a string".
    [[noreturn]] void failType(std::string_view expected) const;
};

SourcePosition positionIn(const std::string& file, const toml::source_region& region);

std::string readText(const TomlValue& value);
bool readBoolean(const TomlValue& value);
/// Integers are valid; NaN, infinity and values that overflow float are not.
float readNumber(const TomlValue& value, const NumberRange& range);
int readInteger(const TomlValue& value, int lowest, int highest);
std::size_t readChoice(const TomlValue& value, std::span<const std::string_view> names);
/// The array in `value`, which must have `size` elements; `what` is the plural of an element in messages.
const toml::array& readArray(const TomlValue& value, std::size_t size, std::string_view what);
const toml::table& readTable(const TomlValue& value);
/// [r, g, b], linear, or { srgb = [r, g, b] }.
Rgb readColor(const TomlValue& value, const NumberRange& range);

template <int N>
glm::vec<N, float> readVector(const TomlValue& value, const NumberRange& range = kAnyNumber) {
    const toml::array& array = readArray(value, static_cast<std::size_t>(N), "numbers");
    glm::vec<N, float> vector;
    for (int i = 0; i < N; ++i)
        vector[i] = readNumber({value.file, array[static_cast<std::size_t>(i)], value.key}, range);
    return vector;
}

}  // namespace rayscope::scene
