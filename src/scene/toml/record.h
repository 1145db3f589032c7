#pragma once
// A record describes the keys of one kind of table in a scene file: name, type, range and the member that is
// set. Reading, checks for unknown and missing keys, and the lists of keys in error messages are derived from
// it.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "base/nearest_name.h"
#include "scene/toml/values.h"

namespace rayscope::scene {

template <class T>
struct Field {
    std::string_view key;
    std::function<void(const TomlValue&, T&)> read;
    bool isRequired = false;

    Field required() && {
        isRequired = true;
        return std::move(*this);
    }
};

template <class T>
using Record = std::vector<Field<T>>;

/// Throws InputError at the first key that is not in `keys`. `owner` names the table in messages: "a camera".
inline void checkKeys(const std::string& file, const toml::table& table, std::string_view owner,
                      std::span<const std::string_view> keys) {
    for (auto&& [key, node] : table) {
        if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
        throw InputError(fmt::format("unknown key '{}' in {}{}; expected {}", key.str(), owner,
                                     base::didYouMean(key.str(), keys), base::joinChoices(keys)),
                         positionIn(file, key.source()));
    }
}

/// Reads the keys of `table` into `target`. Keys in `others` are valid too, but left to the caller. Throws
/// InputError at unknown or missing keys and invalid values.
template <class T>
void readRecord(const std::string& file, const toml::table& table, std::string_view owner,
                const Record<T>& record, T& target, std::span<const std::string_view> others = {}) {
    std::vector<std::string_view> keys(others.begin(), others.end());
    for (const Field<T>& field : record) keys.push_back(field.key);
    checkKeys(file, table, owner, keys);
    for (const Field<T>& field : record) {
        if (const toml::node* node = table.get(field.key))
            field.read({file, *node, field.key}, target);
        else if (field.isRequired)
            throw InputError(fmt::format("{} needs the key '{}'", owner, field.key),
                             positionIn(file, table.source()));
    }
}

template <class T>
Field<T> number(std::string_view key, float T::*member, NumberRange range = kAnyNumber) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readNumber(value, range); }};
}

template <class T>
Field<T> integer(std::string_view key, int T::*member, int lowest, int highest) {
    return {key, [=](const TomlValue& value, T& t) { t.*member = readInteger(value, lowest, highest); }};
}

template <class T>
Field<T> boolean(std::string_view key, bool T::*member) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readBoolean(value); }};
}

template <class T>
Field<T> text(std::string_view key, std::string T::*member) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readText(value); }};
}

template <class T, int N>
Field<T> vector(std::string_view key, glm::vec<N, float> T::*member, NumberRange range = kAnyNumber) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readVector<N>(value, range); }};
}

template <class T>
Field<T> color(std::string_view key, Rgb T::*member, NumberRange range = kFraction) {
    return {key, [=](const TomlValue& value, T& target) { target.*member = readColor(value, range); }};
}

template <class T, std::size_t N>
Field<T> vectors(std::string_view key, std::array<glm::vec3, N> T::*member) {
    return {key, [=](const TomlValue& value, T& target) {
                const toml::array& array = readArray(value, N, "vectors");
                for (std::size_t i = 0; i < N; ++i)
                    (target.*member)[i] = readVector<3>({value.file, array[i], value.key});
            }};
}

template <class T, std::size_t N>
Field<T> colors(std::string_view key, std::array<Rgb, N> T::*member, NumberRange range = kFraction) {
    return {key, [=](const TomlValue& value, T& target) {
                const toml::array& array = readArray(value, N, "colours");
                for (std::size_t i = 0; i < N; ++i)
                    (target.*member)[i] = readColor({value.file, array[i], value.key}, range);
            }};
}

/// `names` are in the order of the enumerators of E.
template <class T, class E, std::size_t N>
Field<T> choice(std::string_view key, E T::*member, std::array<std::string_view, N> names) {
    return {key, [=](const TomlValue& value, T& target) {
                target.*member = static_cast<E>(readChoice(value, names));
            }};
}

/// A nested table. `inner` must outlive the field.
template <class T, class R>
Field<T> table(std::string_view key, std::optional<R> T::*member, const Record<R>& inner) {
    return {key, [=, &inner](const TomlValue& value, T& target) {
                readRecord(value.file, readTable(value), key, inner, (target.*member).emplace());
            }};
}

}  // namespace rayscope::scene
