#include "scene/mesh_files/gltf/json_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace rayscope::scene {

namespace {

using Json = nlohmann::json;
constexpr int kMaxDepth = 512;  // the format itself needs about ten; more is only in application data

/// The nesting of the text. The callbacks of the library would tell it too, in a time quadratic in the length
/// of arrays.
int depthOf(std::string_view text) {
    int depth = 0, deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString && c == '\\')
            ++i;
        else if (c == '"')
            inString = !inString;
        else if (!inString && (c == '[' || c == '{'))
            deepest = std::max(deepest, ++depth);
        else if (!inString && (c == ']' || c == '}'))
            --depth;
    }
    return deepest;
}

SourcePosition positionOfByte(std::string_view text, std::size_t byte, const std::string& file) {
    const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const std::size_t lineStart = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return {file, static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<int>(before.size() - lineStart) + 1};
}

/// The reason in a message of the library, "[json.exception…] parse error at line …: REASON".
std::string reasonOf(const std::exception& error) {
    std::string reason = error.what();
    if (const auto at = reason.find("syntax error"); at != reason.npos) reason = reason.substr(at);
    if (const auto at = reason.find("] "); reason.starts_with("[json") && at != reason.npos)
        reason = reason.substr(at + 2);
    constexpr std::size_t kMaxLength = 200;
    return reason.substr(0, kMaxLength);
}

/// The value of an integral number of at least 0, also if it is written as 3.0.
std::optional<std::uint64_t> integerOf(const Json& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (!value.is_number_float()) return std::nullopt;
    const double number = value.get<double>();
    constexpr double kLimit = 9007199254740992.0;  // 2^53
    if (!(number >= 0.0 && number <= kLimit) || std::floor(number) != number) return std::nullopt;
    return static_cast<std::uint64_t>(number);
}

}  // namespace

JsonObject::JsonObject(const Json& json, std::string place, const std::string& file)
    : json_(&json), place_(std::move(place)), file_(&file) {
    if (!json.is_object()) failType("", "an object", json);
}

std::string JsonObject::placeOf(std::string_view key) const {
    if (key.empty()) return place_.empty() ? "the document" : place_;
    return place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key);
}

void JsonObject::fail(std::string_view key, std::string_view message) const {
    throw InputError(fmt::format("{}: {}", placeOf(key), message), {*file_});
}

void JsonObject::failType(std::string_view key, std::string_view expected, const Json& got) const {
    std::string text = got.dump(-1, ' ', true, Json::error_handler_t::replace);
    constexpr std::size_t kMaxLength = 40;
    if (text.size() > kMaxLength) text = text.substr(0, kMaxLength) + "…";
    fail(key, fmt::format("expected {}, got {}", expected, text));
}

const Json* JsonObject::find(std::string_view key) const {
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}

const Json* JsonObject::findArray(std::string_view key) const {
    const Json* value = find(key);
    if (value && !value->is_array()) failType(key, "an array", *value);
    return value;
}

std::size_t JsonObject::sizeOf(std::string_view key) const {
    const Json* array = findArray(key);
    return array ? array->size() : 0;
}

std::vector<std::string> JsonObject::keys() const {
    std::vector<std::string> list;
    for (const auto& item : json_->items()) list.push_back(item.key());
    return list;
}

std::string JsonObject::text(std::string_view key, std::string fallback) const {
    const Json* value = find(key);
    if (!value) return fallback;
    if (!value->is_string()) failType(key, "a string", *value);
    return value->get<std::string>();
}

std::string JsonObject::textOrNumber(std::string_view key) const {
    const Json* value = find(key);
    return value && value->is_number() ? value->dump() : text(key);
}

std::vector<std::string> JsonObject::texts(std::string_view key) const {
    std::vector<std::string> list;
    const Json* array = findArray(key);
    if (!array) return list;
    for (const Json& value : *array) {
        if (!value.is_string()) failType(key, "an array of strings", *array);
        list.push_back(value.get<std::string>());
    }
    return list;
}

bool JsonObject::boolean(std::string_view key, bool fallback) const {
    const Json* value = find(key);
    if (!value) return fallback;
    if (!value->is_boolean()) failType(key, "true or false", *value);
    return value->get<bool>();
}

double JsonObject::number(std::string_view key, double fallback) const {
    const Json* value = find(key);
    if (!value) return fallback;
    if (!value->is_number()) failType(key, "a number", *value);
    return value->get<double>();
}

std::vector<double> JsonObject::numbers(std::string_view key, std::size_t size) const {
    std::vector<double> list;
    const Json* array = findArray(key);
    if (!array) return list;
    const auto isNumber = [](const Json& value) { return value.is_number(); };
    if (array->size() != size || !std::all_of(array->begin(), array->end(), isNumber))
        failType(key, fmt::format("{} numbers", size), *array);
    for (const Json& value : *array) list.push_back(value.get<double>());
    return list;
}

std::uint64_t JsonObject::integer(std::string_view key, std::optional<std::uint64_t> fallback) const {
    const Json* value = find(key);
    if (!value && !fallback) fail("", fmt::format("the member '{}' is missing", key));
    if (!value) return *fallback;
    const auto number = integerOf(*value);
    if (!number) failType(key, "an integer of at least 0", *value);
    return *number;
}

std::uint32_t JsonObject::toIndex(const Json& value, std::string_view key, std::size_t size,
                                  std::string_view what) const {
    const auto number = integerOf(value);
    if (!number) failType(key, fmt::format("an index into {}", what), value);
    if (*number >= size)
        fail(key, fmt::format("index {} is out of range: {} has {} elements", *number, what, size));
    return static_cast<std::uint32_t>(*number);
}

std::optional<std::uint32_t> JsonObject::index(std::string_view key, std::size_t size,
                                               std::string_view what) const {
    const Json* value = find(key);
    if (!value) return std::nullopt;
    return toIndex(*value, key, size, what);
}

std::uint32_t JsonObject::requiredIndex(std::string_view key, std::size_t size, std::string_view what) const {
    const auto found = index(key, size, what);
    if (!found) fail("", fmt::format("the member '{}' is missing", key));
    return *found;
}

std::vector<std::uint32_t> JsonObject::indices(std::string_view key, std::size_t size,
                                               std::string_view what) const {
    std::vector<std::uint32_t> list;
    const Json* array = findArray(key);
    if (!array) return list;
    for (const Json& value : *array) list.push_back(toIndex(value, key, size, what));
    return list;
}

std::optional<JsonObject> JsonObject::object(std::string_view key) const {
    const Json* value = find(key);
    if (!value) return std::nullopt;
    return JsonObject(*value, placeOf(key), *file_);
}

JsonObject JsonObject::requiredObject(std::string_view key) const {
    auto found = object(key);
    if (!found) fail("", fmt::format("the member '{}' is missing", key));
    return *std::move(found);
}

std::optional<JsonObject> JsonObject::extension(std::string_view name) const {
    const auto extensions = object("extensions");
    return extensions ? extensions->object(name) : std::nullopt;
}

std::vector<JsonObject> JsonObject::objects(std::string_view key) const {
    std::vector<JsonObject> list;
    const Json* array = findArray(key);
    if (!array) return list;
    list.reserve(array->size());
    for (const Json& value : *array)
        list.emplace_back(value, fmt::format("{}[{}]", placeOf(key), list.size()), *file_);
    return list;
}

JsonDocument::JsonDocument(std::string_view text, bool hasLines, const std::string& file)
    : json_(std::make_unique<Json>()), file_(file) {
    if (depthOf(text) > kMaxDepth)
        throw InputError(fmt::format("the JSON is nested more than {} levels deep", kMaxDepth), {file});
    try {
        *json_ = Json::parse(text.begin(), text.end());
    } catch (const Json::parse_error& error) {
        if (hasLines)
            throw InputError("not valid JSON: " + reasonOf(error), positionOfByte(text, error.byte, file));
        throw InputError(
            fmt::format("the JSON chunk is not valid, at its byte {}: {}", error.byte, reasonOf(error)),
            {file});
    } catch (const Json::exception& error) {
        throw InputError("not valid JSON: " + reasonOf(error), {file});
    }
}

JsonDocument::~JsonDocument() = default;

JsonObject JsonDocument::root() const { return JsonObject(*json_, "", file_); }

}  // namespace rayscope::scene
