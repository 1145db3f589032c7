#include "scene/toml/field_texts.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "base/parse_number.h"

namespace rayscope::scene {

namespace {

/// The shortest text that is read, as a double that is rounded to float, as the same bits.
std::string numberText(float x) {
    if (x == 0.0f) return std::signbit(x) ? "-0.0" : "0";
    const std::string text = fmt::format("{}", x);
    const std::optional<double> read = base::parseReal<double>(text);
    return read && static_cast<float>(*read) == x ? text : fmt::format("{}", static_cast<double>(x));
}

std::string vectorText(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", numberText(v.x), numberText(v.y), numberText(v.z));
}

template <class Vectors>
std::string vectorsText(const Vectors& vectors) {
    std::vector<std::string> texts;
    for (const auto& v : vectors) texts.push_back(vectorText(v));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}

Fields shapeFields(const PointLight& light) {
    return {
        {"type", "\"point\""}, {"position", vectorText(light.position)}, {"color", vectorText(light.color)}};
}
Fields shapeFields(const SegmentLight& light) {
    return {{"type", "\"segment\""},
            {"endpoints", vectorsText(light.endpoints)},
            {"colors", vectorsText(light.colors)}};
}
Fields shapeFields(const ParallelogramLight& light) {
    return {{"type", "\"parallelogram\""},
            {"corner", vectorText(light.corner)},
            {"edges", vectorsText(light.edges)},
            {"colors", vectorsText(light.colors)}};
}

}  // namespace

std::string quotedText(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            quoted += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            quoted += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
        else
            quoted += c;
    }
    return quoted + "\"";
}

std::string inlineText(const Fields& fields) {
    std::vector<std::string> texts;
    for (const KeyText& field : fields) texts.push_back(field.key + " = " + field.value);
    return fmt::format("{{ {} }}", fmt::join(texts, ", "));
}

std::string tableText(std::string_view header, const Fields& fields) {
    std::string text = fmt::format("\n{}\n", header);
    for (const KeyText& field : fields) text += field.key + " = " + field.value + "\n";
    return text;
}

Fields fieldsOf(const Lens& lens) {
    return {{"f_number", numberText(lens.fNumber)},
            {"focal_length", numberText(lens.focalLength)},
            {"focus_distance", numberText(lens.focusDistance)}};
}

Fields fieldsOf(const CameraDescription& camera) {
    Fields fields{{"name", quotedText(camera.name)},
                  {"look_from", vectorText(camera.lookFrom)},
                  {"look_at", vectorText(camera.lookAt)},
                  {"up", vectorText(camera.up)},
                  {"fov", numberText(camera.fov)}};
    if (camera.lens) fields.push_back({"lens", inlineText(fieldsOf(*camera.lens))});
    return fields;
}

Fields fieldsOf(const Light& light) {
    Fields fields = std::visit([](const auto& shape) { return shapeFields(shape); }, light.shape);
    if (light.falloff == Falloff::InverseSquare) fields.push_back({"falloff", "\"inverse_square\""});
    return fields;
}

}  // namespace rayscope::scene
