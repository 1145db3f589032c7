#pragma once
// The syntax of the command line. Only command_line.cpp includes the parser library, which is slow to
// compile.
#include <cstdint>
#include <deque>
#include <functional>
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

/// An option, a flag or a positional argument of a command.
struct Option {
    /// The variable that is set; it holds the default before. A `bool` makes a flag without a value, a vector
    /// takes one value each time the option is given.
    using Target =
        std::variant<bool*, int*, float*, double*, std::uint64_t*, std::string*, std::optional<int>*,
                     std::optional<float>*, std::optional<double>*, std::vector<std::string>*>;
    enum class Sign { Positive, NonNegative };
    /// Which values are accepted: inclusive ranges or a list of texts.
    using Check = std::variant<std::monostate, std::pair<int, int>, std::pair<double, double>, Sign,
                               std::vector<std::string>>;

    std::string names;  ///< "-o,--output", or a name without dashes for a positional argument
    Target target;
    std::string help;
    Check check{};
    bool isRequired = false, showsDefault = false;
    char separator = 0;                         ///< of several values in one argument; 0: none
    std::optional<std::string> impliedValue{};  ///< if the option is given without a value

    Option& required() { return isRequired = true, *this; }
    Option& showDefault() { return showsDefault = true, *this; }
    Option& range(int lowest, int highest) { return check = std::pair(lowest, highest), *this; }
    Option& range(double lowest, double highest) { return check = std::pair(lowest, highest), *this; }
    Option& positive() { return check = Sign::Positive, *this; }
    Option& nonNegative() { return check = Sign::NonNegative, *this; }
    Option& choices(std::vector<std::string> texts) { return check = std::move(texts), *this; }
    Option& separatedBy(char character) { return separator = character, *this; }
    Option& valueOptional(std::string implied) { return impliedValue = std::move(implied), *this; }
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
    /// Adds the options and returns the function that runs the command with what they were set to; its result
    /// is the exit code.
    std::function<int()> (*setUp)(OptionList& options);
};

/// Parses the arguments and runs the command that they name. Returns the exit code; --help, --version and
/// errors of use are printed here, the latter with the nearest valid name. Other exceptions pass through.
int runCommandLine(std::span<const Command> commands, const std::vector<std::string>& arguments);

}  // namespace rayscope::cli
