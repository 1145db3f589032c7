#include "scene/toml/values.h"

#include <fmt/format.h>

#include <cmath>

#include "base/nearest_name.h"
#include "image/srgb.h"

namespace rayscope::scene {

namespace {

std::string_view typeOf(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "a boolean";
        default:
            return "a date or time";
    }
}

}  // namespace

std::string NumberRange::text() const {
    const NumberRange all;
    const bool below = highest<all.highest, above = lowest> all.lowest;
    if (above && below && !openLow && !openHigh) return fmt::format(" from {} to {}", lowest, highest);
    std::string range;
    if (above) range += fmt::format("{}{}", openLow ? " above " : " of at least ", lowest);
    if (above && below) range += " and";
    if (below) range += fmt::format("{}{}", openHigh ? " below " : " of at most ", highest);
    return range;
}

SourcePosition positionIn(const std::string& file, const toml::source_region& region) {
    return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

SourcePosition TomlValue::position() const { return positionIn(file, node.source()); }

void TomlValue::fail(std::string_view message) const {
    throw InputError(fmt::format("{}: {}", key, message), position());
}

void TomlValue::failType(std::string_view expected) const {
    fail(fmt::format("expected {}, got {}", expected, typeOf(node)));
}

std::string readText(const TomlValue& value) {
    if (!value.node.is_string()) value.failType("a string");
    return value.node.as_string()->get();
}

bool readBoolean(const TomlValue& value) {
    if (!value.node.is_boolean()) value.failType("true or false");
    return value.node.as_boolean()->get();
}

float readNumber(const TomlValue& value, const NumberRange& range) {
    const std::string expected = "a number" + range.text();
    double number = 0.0;
    if (value.node.is_integer())
        number = static_cast<double>(value.node.as_integer()->get());
    else if (value.node.is_floating_point())
        number = value.node.as_floating_point()->get();
    else
        value.failType(expected);
    if (!std::isfinite(number)) value.fail(fmt::format("expected a finite number, got {}", number));
    // The rounded value is checked too: a double just above the end of an open range may round to the end.
    const float rounded = static_cast<float>(number);
    if (!std::isfinite(rounded) || !range.contains(number) || !range.contains(rounded))
        value.fail(fmt::format("expected {}, got {}", expected, number));
    return rounded;
}

int readInteger(const TomlValue& value, int lowest, int highest) {
    const std::string expected = fmt::format("an integer from {} to {}", lowest, highest);
    if (!value.node.is_integer()) value.failType(expected);
    const std::int64_t number = value.node.as_integer()->get();
    if (number < lowest || number > highest) value.fail(fmt::format("expected {}, got {}", expected, number));
    return static_cast<int>(number);
}

std::size_t readChoice(const TomlValue& value, std::span<const std::string_view> names) {
    const std::string expected = base::joinChoices(names);
    if (!value.node.is_string()) value.failType(expected);
    const std::string& text = value.node.as_string()->get();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return i;
    value.fail(fmt::format("expected {}, got '{}'{}", expected, text, base::didYouMean(text, names)));
}

const toml::array& readArray(const TomlValue& value, std::size_t size, std::string_view what) {
    const std::string expected = fmt::format("an array of {} {}", size, what);
    const toml::array* array = value.node.as_array();
    if (!array) value.failType(expected);
    if (array->size() != size)
        value.fail(fmt::format("expected {}, got {} elements", expected, array->size()));
    return *array;
}

const toml::table& readTable(const TomlValue& value) {
    const toml::table* table = value.node.as_table();
    if (!table) value.failType("a table");
    return *table;
}

Rgb readColor(const TomlValue& value, const NumberRange& range) {
    const toml::table* table = value.node.as_table();
    if (!table) return readVector<3>(value, range);
    const toml::node* srgb = table->get("srgb");
    if (!srgb || table->size() != 1) value.fail("expected a colour: [r, g, b] or { srgb = [r, g, b] }");
    const Rgb encoded = readVector<3>({value.file, *srgb, "srgb"}, kFraction);
    return {image::srgbToLinear(encoded.r), image::srgbToLinear(encoded.g), image::srgbToLinear(encoded.b)};
}

}  // namespace rayscope::scene
