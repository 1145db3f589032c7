#pragma once
// What the program accepts on its command line: commands, their options, and the values of these.
#include <rayscope/vector.h>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rayscope::cli {

/// Wrong use of the command line: exit code 1.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    UsageError(const std::string& option, const std::string& problem)
        : std::runtime_error(option + ": " + problem) {}
};

/// The numbers that an option accepts. NaN and infinity are in no range.
struct NumberRange {
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
    bool isLowestExcluded = false, isHighestExcluded = false;

    bool contains(double value) const;
};

/// An option, a flag or a positional argument of a command.
struct Option {
    /// The variable that is set; it holds the default before. A `bool` makes a flag without a value, a vector
    /// of texts takes one value each time the option is given. Vectors of numbers are written with a
    /// separator, see form().
    using Target = std::variant<bool*, int*, float*, double*, std::uint64_t*, std::string*, glm::ivec2*,
                                std::optional<int>*, std::optional<float>*, std::optional<double>*,
                                std::optional<glm::vec3>*, std::optional<glm::ivec2>*,
                                std::optional<glm::ivec4>*, std::vector<std::string>*>;
    /// What is written to the path that an option names. It is checked before the command runs.
    enum class Output { None, File, Image, ImageOrStandardOutput, ImageOrTable, Folder };

    std::string names;  ///< "-o,--output", or a name without dashes for a positional argument
    Target target;
    std::string help;
    std::vector<std::string> accepted{};  ///< texts; empty: any
    /// Texts that the completions of shells offer, while others are accepted too.
    std::vector<std::string> (*suggestions)() = nullptr;
    NumberRange range{};
    std::string valueForm{};  ///< "X,Y,Z"
    char separator = 0;       ///< of several values in one argument; 0: none
    Output output = Output::None;
    bool isInput = false;  ///< names a file that is read, as positional arguments do
    bool isRequired = false, showsDefault = false;
    std::optional<std::string> impliedValue{};  ///< if the option is given without a value

    Option& required() { return isRequired = true, *this; }
    Option& showDefault() { return showsDefault = true, *this; }
    Option& from(double lowest, double highest) { return range = {lowest, highest}, *this; }
    Option& atLeast(double lowest) { return range.lowest = lowest, *this; }
    Option& above(double lowest) { return range.lowest = lowest, range.isLowestExcluded = true, *this; }
    Option& below(double highest) { return range.highest = highest, range.isHighestExcluded = true, *this; }
    Option& atMost(double highest) { return range.highest = highest, *this; }
    Option& choices(std::vector<std::string> texts) { return accepted = std::move(texts), *this; }
    Option& suggest(std::vector<std::string> (*texts)()) { return suggestions = texts, *this; }
    /// How the value is written, such as "WxH" with the separator 'x'.
    Option& form(std::string text, char between = 0) {
        return valueForm = std::move(text), separator = between, *this;
    }
    Option& separatedBy(char character) { return separator = character, *this; }
    Option& reads() { return isInput = true, *this; }
    Option& writes(Output kind) { return output = kind, *this; }
    Option& valueOptional(std::string implied) { return impliedValue = std::move(implied), *this; }

    bool isPositional() const { return !names.starts_with('-'); }
    bool isFlag() const { return std::holds_alternative<bool*>(target); }
    /// "-o,--output" as {"-o", "--output"}.
    std::vector<std::string_view> nameList() const;
    /// The first long name, or the name of a positional argument.
    std::string_view mainName() const;
};

/// The options of one command, in the order of its --help.
class OptionList {
  public:
    Option& add(std::string names, Option::Target target, std::string help) {
        return options_.emplace_back(Option{std::move(names), target, std::move(help)});
    }
    /// Text of --help below the options.
    void setDetails(std::string text) { details_ = std::move(text); }

    const std::deque<Option>& options() const { return options_; }
    const std::string& details() const { return details_; }

  private:
    std::deque<Option> options_;  ///< references to its elements stay valid
    std::string details_;
};

/// A sub-command of the program.
struct Command {
    std::string_view name, summary;
    /// Adds the options and returns the function that runs the command with what they were set to and owns
    /// the variables that they set; its result is the exit code. The list must outlive the function.
    std::function<int()> (*setUp)(OptionList& options);
};

/// Parses the arguments and runs the command that they name, or `view` for a scene without a command. Returns
/// the exit code; --help, --version and errors of use are printed here. Other exceptions pass through.
int runCommandLine(std::span<const Command> commands, const std::vector<std::string>& arguments);

}  // namespace rayscope::cli
