// Every option of every command, from the tables that the program itself uses: a new option is covered at
// once.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/settings.h>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/option_value.h"

namespace rayscope::cli {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An option whose value is one number, or several of the same range.
struct NumberOption {
    std::string command;
    const Option* option;
    bool isInteger;
    int count;  ///< of numbers in the value
};

template <class Target>
bool holds(const Option& option) {
    return std::holds_alternative<Target>(option.target);
}

/// The commands with their options; the functions own the variables that the options set.
struct CommandOptions {
    const Command* command;
    OptionList list;
    std::function<int()> run;
};

const std::deque<CommandOptions>& allCommands() {
    static const std::deque<CommandOptions> commands = [] {
        std::deque<CommandOptions> made;
        for (const Command& command : commandTable()) {
            CommandOptions& entry = made.emplace_back();
            entry.command = &command;
            entry.run = command.setUp(entry.list);
        }
        return made;
    }();
    return commands;
}

std::vector<NumberOption> numberOptions() {
    std::vector<NumberOption> found;
    for (const CommandOptions& entry : allCommands())
        for (const Option& option : entry.list.options()) {
            const int count = holds<std::optional<glm::vec3>*>(option)                                  ? 3
                              : holds<glm::ivec2*>(option) || holds<std::optional<glm::ivec2>*>(option) ? 2
                              : holds<std::optional<glm::ivec4>*>(option)                               ? 4
                                                                                                        : 1;
            const bool isReal = holds<float*>(option) || holds<double*>(option) ||
                                holds<std::optional<float>*>(option) ||
                                holds<std::optional<double>*>(option) || count == 3;
            const bool isInteger = holds<int*>(option) || holds<std::optional<int>*>(option) ||
                                   holds<std::uint64_t*>(option) || count == 2 || count == 4;
            if (isReal || isInteger)
                found.push_back({std::string(entry.command->name), &option, isInteger, count});
        }
    return found;
}

/// `text` as one of the numbers of the value; the others are valid.
std::string valueWith(const NumberOption& number, const std::string& text, int place) {
    const double low = number.option->range.lowest;
    const std::string valid = fmt::format("{}", std::isfinite(low) ? std::floor(low) + 1.0 : 1.0);
    std::string value;
    for (int i = 0; i < number.count; ++i) {
        if (i > 0) value += number.option->separator;
        value += i == place ? text : valid;
    }
    return value;
}

/// "" if the value is accepted, else the message.
std::string refusal(const Option& option, const std::string& value) {
    try {
        setValue(option, value);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

void expectRefused(const NumberOption& number, const std::string& text) {
    for (int place = 0; place < number.count; ++place) {
        const std::string value = valueWith(number, text, place);
        const std::string message = refusal(*number.option, value);
        const std::string context = fmt::format("{} {} '{}'", number.command, number.option->names, value);
        ASSERT_NE(message, "") << context;
        EXPECT_TRUE(message.starts_with(std::string(number.option->mainName()) + ": expected ")) << message;
        EXPECT_THAT(message, HasSubstr(expectationOf(*number.option))) << context;
        EXPECT_LE(message.size(), 200u) << context;
    }
}

void expectAccepted(const NumberOption& number, const std::string& text) {
    const std::string value = valueWith(number, text, 0);
    EXPECT_EQ(refusal(*number.option, value), "") << number.command << " " << number.option->names;
}

TEST(OptionTable, HasTheNumberOptionsThatThisTestIsAbout) {
    std::set<std::string_view> names;
    for (const NumberOption& number : numberOptions()) names.insert(number.option->mainName());
    for (const char* name : {"--threads",    "--size",
                             "--look-from",  "--look-at",
                             "--up",         "--fov",
                             "--spp",        "--seed",
                             "--time-limit", "--target-error",
                             "--confidence", "--pixelbounds",
                             "--pixel",      "--sample",
                             "--rounds",     "--budget",
                             "--rays",       "--fail-above",
                             "--tile",       "--range",
                             "--exposure",   "--pixels-per-degree",
                             "--lens",       "--neighbourhood"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(OptionTable, TextsThatAreNoNumberAreRefusedEverywhere) {
    for (const NumberOption& number : numberOptions()) {
        for (const char* text : {"nan", "-nan",  "NaN",  "inf",   "-inf", "infinity", "",
                                 " ",   "  4",   "4 ",   "0x10",  "1e",   "4x",       "--4",
                                 "+-4", "1.2.3", "four", "1_000", "\xe9", "4\n",      "1e999999999999"})
            expectRefused(number, text);
        expectRefused(number, std::string(400, '9'));
        expectRefused(number, std::string(100000, 'x'));
        if (number.option->separator != ',') expectRefused(number, "1,5");
        // One too few, one too many.
        if (number.count > 1) {
            EXPECT_NE(refusal(*number.option, "4"), "");
            EXPECT_NE(refusal(*number.option, valueWith(number, "4", 0) + number.option->separator + "4"),
                      "");
            EXPECT_NE(refusal(*number.option, valueWith(number, "4", 0) + number.option->separator), "");
        }
    }
}

TEST(OptionTable, IntegersHaveNoFractionAndNoExponent) {
    for (const NumberOption& number : numberOptions())
        if (number.isInteger)
            for (const char* text :
                 {"0.5", "4.0", "8.5", "1e1", "1e39", "18446744073709551616", "-9223372036854775809"})
                expectRefused(number, text);
}

TEST(OptionTable, FloatsBeyondTheirTypeAreRefused) {
    for (const NumberOption& number : numberOptions()) {
        if (number.isInteger) continue;
        expectRefused(number, "1e400");
        expectRefused(number, "-1e400");
        if (number.count == 3 || holds<float*>(*number.option) ||
            holds<std::optional<float>*>(*number.option))
            expectRefused(number, "1e39");
    }
}

TEST(OptionTable, LimitsAreAcceptedAndTheirOuterNeighboursRefused) {
    for (const NumberOption& number : numberOptions()) {
        const NumberRange& range = number.option->range;
        const auto text = [&](double value) {
            return number.isInteger ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
        };
        const bool isFloat = holds<float*>(*number.option) || holds<std::optional<float>*>(*number.option) ||
                             holds<std::optional<glm::vec3>*>(*number.option);
        const auto neighbour = [&](double value, double towards) {
            if (number.isInteger) return value + (towards > value ? 1.0 : -1.0);
            if (isFloat)
                return static_cast<double>(
                    std::nextafter(static_cast<float>(value), static_cast<float>(towards)));
            return std::nextafter(value, towards);
        };
        if (std::isfinite(range.lowest)) {
            expectRefused(number, text(neighbour(range.lowest, -kInfinity)));
            if (range.isLowestExcluded)
                expectRefused(number, text(range.lowest));
            else
                expectAccepted(number, text(range.lowest));
            expectAccepted(number, text(neighbour(range.lowest, kInfinity)));
        }
        if (std::isfinite(range.highest)) {
            // Beyond the integers of the type there is nothing to test.
            expectRefused(number, text(neighbour(range.highest, kInfinity)));
            if (range.isHighestExcluded)
                expectRefused(number, text(range.highest));
            else
                expectAccepted(number, text(range.highest));
        }
        if (range.lowest >= 0.0 || holds<std::uint64_t*>(*number.option)) expectRefused(number, "-1");
    }
}

TEST(OptionTable, SeedsUseAll64Bits) {
    std::uint64_t seed = 0;
    OptionList list;
    const Option& option = list.add("--seed", &seed, "");
    setValue(option, "18446744073709551615");
    EXPECT_EQ(seed, std::numeric_limits<std::uint64_t>::max());
    EXPECT_NE(refusal(option, "18446744073709551616"), "");
    EXPECT_NE(refusal(option, "-1"), "");
}

TEST(OptionTable, HelpSaysWhatTheErrorMessagesSay) {
    for (const CommandOptions& entry : allCommands()) {
        std::string help;
        bool isBlank = false;
        for (const char c : helpText(*entry.command, entry.list)) {
            if (c != ' ' && c != '\n')
                help += c;
            else if (!isBlank)
                help += ' ';
            isBlank = c == ' ' || c == '\n';
        }
        for (const Option& option : entry.list.options()) {
            const std::string context = fmt::format("{} {}", entry.command->name, option.names);
            EXPECT_THAT(help, HasSubstr(std::string(option.mainName()))) << context;
            if (const std::string expected = expectationOf(option); !expected.empty()) {
                EXPECT_THAT(help, HasSubstr("(" + expected + ")")) << context;
            }
            for (const std::string& text : option.accepted) EXPECT_THAT(help, HasSubstr(text)) << context;
        }
    }
}

TEST(OptionTable, OptionsOfTheSameNameHaveTheSameRange) {
    std::map<std::string, std::string> expectations;
    for (const NumberOption& number : numberOptions()) {
        const std::string expected = expectationOf(*number.option);
        const auto [known, isNew] = expectations.emplace(number.option->mainName(), expected);
        EXPECT_TRUE(isNew || known->second == expected || number.option->mainName() == "--size")
            << number.command << " " << number.option->names;
    }
}

TEST(OptionTable, ChoicesAreListedWithTheNearest) {
    std::string shown;
    OptionList list;
    const Option& option = list.add("--progress", &shown, "").choices({"bar", "json", "none"});
    EXPECT_EQ(refusal(option, "jsom"),
              "--progress: expected bar, json or none, got 'jsom' (did you mean 'json'?)");
    setValue(option, "json");
    EXPECT_EQ(shown, "json");
}

TEST(OptionTable, SettingsRefuseTheSameTexts) {
    for (const SettingInfo& info : describeSettings()) {
        if (info.kind != "integer" && info.kind != "number") continue;
        for (std::string text : {"nan", "inf", "-inf", "", " ", "1e39", "18446744073709551616", "0x10", "1,5",
                                 "4x", "4 ", "--1", "1e400"}) {
            Settings settings;
            try {
                assign(settings, info.key, text);
                FAIL() << info.key << " = " << text;
            } catch (const std::runtime_error& error) {
                EXPECT_THAT(error.what(), HasSubstr(fmt::format("setting '{}': expected ", info.key)));
                EXPECT_THAT(error.what(), HasSubstr("got '" + text + "'"));
            }
        }
        Settings settings;
        EXPECT_THROW(assign(settings, info.key, std::string(400, '9')), std::runtime_error);
        if (info.kind == "integer") {
            EXPECT_THROW(assign(settings, info.key, "2.5"), std::runtime_error) << info.key;
        }
    }
}

}  // namespace
}  // namespace rayscope::cli
