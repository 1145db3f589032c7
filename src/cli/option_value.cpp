#include "cli/option_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/nearest_name.h"
#include "base/parse_number.h"
#include "base/printable_text.h"
#include "cli/command_line.h"

namespace rayscope::cli {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

constexpr double kLargestFloat = std::numeric_limits<float>::max();

/// "from 1 to 8", "above 0 and below 180", "of at least 0"; "" if every finite number is in the range.
std::string rangeText(const NumberRange& range) {
    const bool hasLowest = std::isfinite(range.lowest), hasHighest = std::isfinite(range.highest);
    const auto number = [](double value) {
        return std::floor(value) == value && std::abs(value) < 1e15 ? fmt::format("{:.0f}", value)
                                                                    : fmt::format("{:g}", value);
    };
    if (hasLowest && hasHighest && !range.isLowestExcluded && !range.isHighestExcluded)
        return fmt::format("from {} to {}", number(range.lowest), number(range.highest));
    std::string text;
    if (hasLowest)
        text = fmt::format("{} {}", range.isLowestExcluded ? "above" : "of at least", number(range.lowest));
    if (hasHighest)
        text += fmt::format("{}{} {}", text.empty() ? "" : " and ",
                            range.isHighestExcluded ? "below" : "at most", number(range.highest));
    return text;
}

std::string withRange(std::string_view what, const Option& option) {
    const std::string range = rangeText(option.range);
    return range.empty() ? std::string(what) : fmt::format("{} {}", what, range);
}

std::string integersText(int count, const Option& option) {
    return fmt::format("{}, {} {}", option.valueForm, count, withRange("integers", option));
}

[[noreturn]] void throwExpected(const Option& option, std::string_view text) {
    throw UsageError(std::string(option.mainName()),
                     fmt::format("expected {}, got {}", expectationOf(option), base::quoted(text)));
}

/// A number that is finite in its type and in the range of the option. The range is that of the rounded
/// value.
template <class Number>
Number parseNumber(const Option& option, std::string_view text, std::string_view whole) {
    if constexpr (std::is_integral_v<Number>) {
        const auto value = base::parseInteger<Number>(text);
        if (!value || !option.range.contains(static_cast<double>(*value))) throwExpected(option, whole);
        return *value;
    } else {
        const std::optional<Number> value = base::parseReal<Number>(text);
        if (!value || !std::isfinite(*value) || !option.range.contains(static_cast<double>(*value)))
            throwExpected(option, whole);
        return *value;
    }
}

template <int kCount, class Vector>
void setVector(const Option& option, std::string_view text, Vector& vector) {
    std::string_view rest = text;
    for (int i = 0; i < kCount; ++i) {
        const std::size_t end = rest.find(option.separator);
        const bool isLast = i + 1 == kCount;
        if ((end == std::string_view::npos) != isLast) throwExpected(option, text);
        vector[i] = parseNumber<typename Vector::value_type>(option, rest.substr(0, end), text);
        if (!isLast) rest.remove_prefix(end + 1);
    }
}

void setText(const Option& option, std::string_view text, std::string& value) {
    if (!option.accepted.empty() &&
        std::find(option.accepted.begin(), option.accepted.end(), text) == option.accepted.end()) {
        const std::vector<std::string_view> known(option.accepted.begin(), option.accepted.end());
        throw UsageError(std::string(option.mainName()),
                         fmt::format("expected {}, got {}{}", base::joinChoices(known), base::quoted(text),
                                     base::didYouMean(text, known)));
    }
    value = text;
}

void addTexts(const Option& option, std::string_view text, std::vector<std::string>& values) {
    while (option.separator != 0 && text.find(option.separator) != std::string_view::npos) {
        const std::size_t end = text.find(option.separator);
        setText(option, text.substr(0, end), values.emplace_back());
        text.remove_prefix(end + 1);
    }
    setText(option, text, values.emplace_back());
}

}  // namespace

bool NumberRange::contains(double value) const {
    const bool isHighEnough = isLowestExcluded ? value > lowest : value >= lowest;
    const bool isLowEnough = isHighestExcluded ? value < highest : value <= highest;
    return isHighEnough && isLowEnough;
}

std::string formOf(const Option& option) {
    if (!option.valueForm.empty()) return option.valueForm;
    if (!option.accepted.empty()) return fmt::format("{}", fmt::join(option.accepted, "|"));
    if (option.output == Option::Output::Folder) return "FOLDER";
    if (option.output != Option::Output::None) return "FILE";
    const Overloaded cases{
        [](const bool*) { return ""; },
        [](const int*) { return "INTEGER"; },
        [](const std::optional<int>*) { return "INTEGER"; },
        [](const std::uint64_t*) { return "INTEGER"; },
        [](const float*) { return "NUMBER"; },
        [](const double*) { return "NUMBER"; },
        [](const std::optional<float>*) { return "NUMBER"; },
        [](const std::optional<double>*) { return "NUMBER"; },
        [](const auto*) { return "TEXT"; },
    };
    return std::visit(cases, option.target);
}

std::string expectationOf(const Option& option) {
    const Overloaded cases{
        [&](const int*) { return withRange("an integer", option); },
        [&](const std::optional<int>*) { return withRange("an integer", option); },
        [](const std::uint64_t*) {
            return fmt::format("an integer from 0 to {}", std::numeric_limits<std::uint64_t>::max());
        },
        [&](const float*) { return withRange("a number", option); },
        [&](const double*) { return withRange("a number", option); },
        [&](const std::optional<float>*) { return withRange("a number", option); },
        [&](const std::optional<double>*) { return withRange("a number", option); },
        [&](const std::optional<glm::vec3>*) {
            const std::string range = rangeText(option.range);
            if (!range.empty()) return fmt::format("{}, 3 numbers {}", option.valueForm, range);
            return fmt::format("{}, 3 numbers from -{:.4g} to {:.4g}", option.valueForm, kLargestFloat,
                               kLargestFloat);
        },
        [&](const glm::ivec2*) { return integersText(2, option); },
        [&](const std::optional<glm::ivec2>*) { return integersText(2, option); },
        [&](const std::optional<glm::ivec4>*) { return integersText(4, option); },
        [](const auto*) { return std::string(); },
    };
    return std::visit(cases, option.target);
}

std::string valueText(const Option& option) {
    const Overloaded cases{
        [](const bool*) { return std::string(); },
        [](const std::string* value) { return *value; },
        [](const int* value) { return fmt::format("{}", *value); },
        [](const float* value) { return fmt::format("{}", *value); },
        [](const double* value) { return fmt::format("{}", *value); },
        [](const std::uint64_t* value) { return fmt::format("{}", *value); },
        [&](const glm::ivec2* value) { return fmt::format("{}{}{}", value->x, option.separator, value->y); },
        [](const std::vector<std::string>* value) { return fmt::format("{}", fmt::join(*value, " ")); },
        [](const auto*) { return std::string(); },
    };
    return std::visit(cases, option.target);
}

void setValue(const Option& option, std::string_view text) {
    const Overloaded cases{
        [](bool* value) { *value = true; },
        [&](std::string* value) { setText(option, text, *value); },
        [&](std::vector<std::string>* values) { addTexts(option, text, *values); },
        [&](glm::ivec2* value) { setVector<2>(option, text, *value); },
        [&](std::optional<glm::ivec2>* value) { setVector<2>(option, text, value->emplace()); },
        [&](std::optional<glm::ivec4>* value) { setVector<4>(option, text, value->emplace()); },
        [&](std::optional<glm::vec3>* value) { setVector<3>(option, text, value->emplace()); },
        [&]<class Number>(std::optional<Number>* value) { *value = parseNumber<Number>(option, text, text); },
        [&]<class Number>(Number* value) { *value = parseNumber<Number>(option, text, text); },
    };
    std::visit(cases, option.target);
}

}  // namespace rayscope::cli
