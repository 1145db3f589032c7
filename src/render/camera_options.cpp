#include <fmt/format.h>
#include <rayscope/open_request.h>

#include <array>
#include <vector>

#include "base/nearest_name.h"
#include "base/number_list.h"
#include "render/scene_defaults.h"

namespace rayscope {

namespace {

std::vector<std::string_view> splitText(std::string_view text) {
    std::vector<std::string_view> list;
    constexpr std::string_view kGaps = " \t\n=";
    for (std::size_t start = text.find_first_not_of(kGaps); start != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(kGaps, start), text.size());
        list.push_back(text.substr(start, end - start));
        start = text.find_first_not_of(kGaps, end);
    }
    return list;
}

std::vector<float> numbers(std::string_view option, std::string_view text, std::size_t count) {
    auto values = base::parseNumbers<float>(text, ',', count);
    if (!values)
        throw InputError(fmt::format("{}: expected {}, got '{}'", option,
                                     count == 1 ? "a number" : "three numbers separated by commas", text));
    return *std::move(values);
}

glm::vec3 vector(std::string_view option, std::string_view text) {
    const std::vector<float> v = numbers(option, text, 3);
    return {v[0], v[1], v[2]};
}

Lens lens(std::string_view option, std::string_view text) {
    const glm::vec3 v = vector(option, text);
    if (!(v.x > 0.0f && v.y > 0.0f && v.z > 0.0f))
        throw InputError(fmt::format("{}: expected numbers above 0, got '{}'", option, text));
    return {v.x, v.y, v.z};
}

}  // namespace

std::string toOptions(const CameraDescription& camera) {
    std::string text =
        fmt::format("--look-from {} --look-at {} --up {} --fov {}", render::optionText(camera.lookFrom),
                    render::optionText(camera.lookAt), render::optionText(camera.up), camera.fov);
    if (camera.lens) text += " --lens " + render::optionText(*camera.lens);
    return text;
}

CameraDescription withOptions(const CameraDescription& camera, std::string_view text) {
    constexpr std::array<std::string_view, 5> kOptions{"--look-from", "--look-at", "--up", "--fov", "--lens"};
    CameraDescription changed = camera;
    const std::vector<std::string_view> list = splitText(text);
    for (std::size_t i = 0; i < list.size(); i += 2) {
        const std::string_view option = list[i];
        const std::string_view value = i + 1 < list.size() ? list[i + 1] : std::string_view{};
        if (option == "--look-from")
            changed.lookFrom = vector(option, value);
        else if (option == "--look-at")
            changed.lookAt = vector(option, value);
        else if (option == "--up")
            changed.up = vector(option, value);
        else if (option == "--fov")
            changed.fov = numbers(option, value, 1)[0];
        else if (option == "--lens")
            changed.lens = lens(option, value);
        else
            throw InputError(fmt::format("expected {}, got '{}'{}", base::joinChoices(kOptions), option,
                                         base::didYouMean(option, kOptions)));
    }
    if (!(changed.fov > 0.0f && changed.fov < 180.0f))
        throw InputError("--fov: expected degrees between 0 and 180");
    render::checkCamera(changed);
    return changed;
}

}  // namespace rayscope
