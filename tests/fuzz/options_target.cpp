#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_value.h"
#include "fuzz/targets.h"

namespace rayscope::test {

namespace {

using cli::Option;

/// The numbers that a variable holds; none for texts and flags.
struct NumbersOf {
    using Numbers = std::vector<double>;

    template <class Number>
    requires std::is_arithmetic_v<Number> Numbers operator()(const Number* value) const {
        return {static_cast<double>(*value)};
    }
    template <int kCount, class Number>
    Numbers operator()(const glm::vec<kCount, Number>* value) const {
        Numbers numbers;
        for (int i = 0; i < kCount; ++i) numbers.push_back(static_cast<double>((*value)[i]));
        return numbers;
    }
    template <class Value>
    Numbers operator()(const std::optional<Value>* value) const {
        return *value ? (*this)(&**value) : Numbers{};
    }
    Numbers operator()(const bool*) const { return {}; }
    Numbers operator()(const std::string*) const { return {}; }
    Numbers operator()(const std::vector<std::string>*) const { return {}; }
};

std::vector<double> numbersOf(const Option& option) { return std::visit(NumbersOf{}, option.target); }

bool areInRange(const Option& option) {
    return std::ranges::all_of(numbersOf(option), [&](double number) {
        return std::isfinite(number) && option.range.contains(number);
    });
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

}  // namespace

/// The lines of any text are arguments of the program: every number of an accepted command line is in the
/// range of its option, and other command lines are refused with UsageError. Nothing is run.
bool fuzzOptions(FuzzInput input) {
    try {
        const cli::CommandArguments arguments = cli::findCommand(cli::commandTable(), wordsOf(textOf(input)));
        if (!arguments.command) return true;
        cli::OptionList list;
        const std::function<int()> run = arguments.command->setUp(list);
        // Defaults may lie outside of the range, as marks for what is not given.
        std::vector<std::vector<double>> defaults;
        for (const Option& option : list.options()) defaults.push_back(numbersOf(option));
        if (!cli::parseOptions(*arguments.command, list, arguments.rest)) return true;
        auto unset = defaults.begin();
        for (const Option& option : list.options())
            require(numbersOf(option) == *unset++ || areInRange(option),
                    "the numbers of options are in their ranges");
    } catch (const cli::UsageError&) {
    }
    return true;
}

}  // namespace rayscope::test
