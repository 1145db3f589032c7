#include "cli/number_list.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "cli/command_line.h"

namespace rayscope::cli {

namespace {
[[noreturn]] void throwExpected(const std::string& option, const std::string& what, const std::string& text) {
    throw UsageError(option, fmt::format("expected {}, got '{}'", what, text));
}
}  // namespace

std::vector<double> parseNumbers(const std::string& option, const std::string& text, char separator,
                                 int count) {
    std::vector<double> numbers;
    const std::string what = fmt::format("{} numbers separated by '{}'", count, separator);
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (;;) {
        double value = 0.0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc{} || !std::isfinite(value)) throwExpected(option, what, text);
        numbers.push_back(value);
        if (next == end) break;
        if (*next != separator) throwExpected(option, what, text);
        at = next + 1;
    }
    if (numbers.size() != static_cast<std::size_t>(count)) throwExpected(option, what, text);
    return numbers;
}

glm::vec3 parseVector(const std::string& option, const std::string& text) {
    const std::vector<double> n = parseNumbers(option, text, ',', 3);
    return {n[0], n[1], n[2]};
}

glm::ivec2 parsePair(const std::string& option, const std::string& text, char separator, int lowest) {
    const std::vector<double> n = parseNumbers(option, text, separator, 2);
    for (const double value : n)
        if (value != std::floor(value) || value < lowest || value > 1 << 20)
            throwExpected(option, fmt::format("two whole numbers from {} to {}", lowest, 1 << 20), text);
    return {static_cast<int>(n[0]), static_cast<int>(n[1])};
}

}  // namespace rayscope::cli
