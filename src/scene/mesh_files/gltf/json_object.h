#pragma once
#include <rayscope/diagnostics.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// An object of a JSON document, with its place there ("meshes[0].primitives[2]") for messages. All functions
/// throw InputError with the file and the place if a member has another type or value than they expect.
/// `fallback` is the value of absent members.
class JsonObject {
  public:
    /// `json` and `file` must outlive the object. Throws InputError if `json` is not an object.
    JsonObject(const nlohmann::json& json, std::string place, const std::string& file);

    bool has(std::string_view key) const { return find(key) != nullptr; }
    /// The number of elements of an array, 0 if it is absent.
    std::size_t sizeOf(std::string_view key) const;
    std::vector<std::string> keys() const;

    std::string text(std::string_view key, std::string fallback = {}) const;
    /// text(), or the digits of a number.
    std::string textOrNumber(std::string_view key) const;
    std::vector<std::string> texts(std::string_view key) const;
    bool boolean(std::string_view key, bool fallback) const;
    double number(std::string_view key, double fallback) const;
    /// `size` numbers, or nothing if the member is absent.
    std::vector<double> numbers(std::string_view key, std::size_t size) const;
    /// Any number of numbers.
    std::vector<double> numbers(std::string_view key) const { return numbers(key, sizeOf(key)); }
    /// An integer of at least 0; without a fallback the member is required.
    std::uint64_t integer(std::string_view key, std::optional<std::uint64_t> fallback = {}) const;
    /// An index into an array of `size` elements, which messages call `what`; nothing if absent.
    std::optional<std::uint32_t> index(std::string_view key, std::size_t size, std::string_view what) const;
    std::uint32_t requiredIndex(std::string_view key, std::size_t size, std::string_view what) const;
    std::vector<std::uint32_t> indices(std::string_view key, std::size_t size, std::string_view what) const;
    std::optional<JsonObject> object(std::string_view key) const;
    JsonObject requiredObject(std::string_view key) const;
    /// The object `name` in the member "extensions".
    std::optional<JsonObject> extension(std::string_view name) const;
    /// The elements of an array of objects; empty if it is absent.
    std::vector<JsonObject> objects(std::string_view key) const;

    /// Throws InputError: "PLACE.KEY: MESSAGE", or "PLACE: MESSAGE" with an empty key.
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;

  private:
    const nlohmann::json* find(std::string_view key) const;
    const nlohmann::json* findArray(std::string_view key) const;
    std::string placeOf(std::string_view key) const;
    [[noreturn]] void failType(std::string_view key, std::string_view expected,
                               const nlohmann::json& got) const;
    std::uint32_t toIndex(const nlohmann::json& value, std::string_view key, std::size_t size,
                          std::string_view what) const;

    const nlohmann::json* json_;
    std::string place_;
    const std::string* file_;
};

/// A parsed JSON text.
class JsonDocument {
  public:
    /// Throws InputError if the text is not JSON or is nested more than 512 levels deep. `hasLines`: the
    /// whole file is this text, so that messages can name the line; else they name the byte of the text.
    /// `file` must outlive the document.
    JsonDocument(std::string_view text, bool hasLines, const std::string& file);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    JsonObject root() const;

  private:
    std::unique_ptr<nlohmann::json> json_;
    const std::string& file_;
};

}  // namespace rayscope::scene
