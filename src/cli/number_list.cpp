#include "cli/number_list.h"

#include <fmt/format.h>

#include <cmath>

#include "base/number_list.h"
#include "cli/command_line.h"

namespace rayscope::cli {

namespace {

constexpr int kLargestCoordinate = 1 << 20;

[[noreturn]] void throwExpected(const std::string& option, const std::string& what, const std::string& text) {
    throw UsageError(option, fmt::format("expected {}, got '{}'", what, text));
}

template <class Number>
std::vector<Number> parse(const std::string& option, const std::string& text, char separator, int count) {
    auto numbers = base::parseNumbers<Number>(text, separator, static_cast<std::size_t>(count));
    if (!numbers) throwExpected(option, fmt::format("{} numbers separated by '{}'", count, separator), text);
    return *std::move(numbers);
}

std::vector<int> parseWhole(const std::string& option, const std::string& text, char separator, int count,
                            int lowest) {
    std::vector<int> whole;
    for (const double value : parse<double>(option, text, separator, count)) {
        if (value != std::floor(value) || value < lowest || value > kLargestCoordinate)
            throwExpected(option,
                          fmt::format("{} whole numbers from {} to {}", count, lowest, kLargestCoordinate),
                          text);
        whole.push_back(static_cast<int>(value));
    }
    return whole;
}

}  // namespace

glm::vec3 parseVector(const std::string& option, const std::string& text) {
    const std::vector<float> n = parse<float>(option, text, ',', 3);
    return {n[0], n[1], n[2]};
}

glm::ivec2 parsePair(const std::string& option, const std::string& text, char separator, int lowest) {
    const std::vector<int> n = parseWhole(option, text, separator, 2, lowest);
    return {n[0], n[1]};
}

PixelBounds parseBounds(const std::string& option, const std::string& text) {
    const std::vector<int> n = parseWhole(option, text, ',', 4, 0);
    return {n[0], n[1], n[2], n[3]};
}

}  // namespace rayscope::cli
