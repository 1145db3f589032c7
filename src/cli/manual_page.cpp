#include "cli/manual_page.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/help_text.h"

namespace rayscope::cli {

namespace {

/// Text with the characters escaped that roff would interpret.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (result.empty() && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

std::string section(std::string_view title) { return fmt::format(".SH {}\n", title); }
std::string paragraph(std::string_view text) { return fmt::format(".PP\n{}\n", escaped(text)); }
std::string entry(std::string_view head, std::string_view text) {
    return fmt::format(".TP\n.B {}\n{}\n", escaped(head), escaped(text));
}

std::string commandSection(const Command& command) {
    OptionList list;
    const std::function<int()> owner = command.setUp(list);  // of the variables behind the options
    std::string text =
        fmt::format(".SS {}\n{}.\n", escaped(usageOf(command, list)), escaped(command.summary));
    if (!list.details().empty()) text += paragraph(list.details());
    for (const Option& option : list.options()) text += entry(headOf(option), helpOf(option));
    return text;
}

constexpr std::pair<ExitCode, std::string_view> kExitCodes[] = {
    {kSuccess, "Done."},
    {kUsageError, "Wrong use of the command line."},
    {kInputError,
     "A scene, a setting or a file is wrong, an output cannot be written, or memory or threads ran out."},
    {kStoppedByLimit, "Stopped by a limit before the target was reached; the image is written."},
    {kThresholdExceeded, "compare --fail-above is exceeded, or lab found a failure."},
    {kNonFiniteImage, "The image holds NaN or infinity; it is written, and the pixels are named."},
    {kInterrupted, "Interrupted; the image is written, unless the scene was still being loaded."},
};

constexpr std::pair<std::string_view, std::string_view> kFiles[] = {
    {"share/rayscope, ../share/rayscope",
     "Scenes and scripts, seen from the folder of the program; then rayscope in $XDG_DATA_HOME (else "
     "~/.local/share) and in the folders of $XDG_DATA_DIRS (else /usr/local/share and /usr/share)."},
    {"$XDG_CACHE_HOME/rayscope", "Caches; else ~/.cache/rayscope."},
    {"$XDG_CONFIG_HOME/rayscope", "The list of recent scenes; else ~/.config/rayscope."},
};

constexpr std::pair<std::string_view, std::string_view> kExamples[] = {
    {"rayscope", "Open the window with the built-in scene."},
    {"rayscope render builtin:cornell --size 320x240 --spp 16 -o cornell.png", "Render an image."},
    {"rayscope probe builtin:cornell --pixel 400,500", "Print the rays of a pixel."},
    {"rayscope info my-model.obj", "Print what a file contains, and what is wrong with it."},
};

}  // namespace

std::string manualPage(std::span<const Command> commands) {
    std::string text = ".\\\" -*- coding: UTF-8 -*-\n";
    text += fmt::format(".TH RAYSCOPE 1 \"\" \"Rayscope {}\" \"User Commands\"\n", RAYSCOPE_VERSION);
    text += section("NAME") + "rayscope \\- interactive ray tracer that shows how each pixel is computed\n";
    text += section("SYNOPSIS") +
            ".B rayscope\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.br\n.B rayscope\n[\\fISCENE\\fR]\n";
    text +=
        section("DESCRIPTION") +
        "Rayscope renders a scene on all cores while you move through it, and records the ray tree of any "
        "pixel that you select: every ray, its hit, and its contribution to the colour of the pixel.\n" +
        paragraph(
            "SCENE is a file or builtin:NAME; rayscope info --list names the built-in scenes. Results go to "
            "the "
            "standard output, messages to standard error.");
    text += section("OPTIONS");
    text += entry("-h, --help", "Print the commands, or the options of the command before it.");
    text += entry("--version", "Print the version, the compiler, the kernels and the libraries.");
    text += section("COMMANDS");
    for (const Command& command : commands) text += commandSection(command);
    text += section("EXIT STATUS");
    for (const auto& [code, meaning] : kExitCodes) text += entry(fmt::format("{}", int{code}), meaning);
    text += section("FILES");
    for (const auto& [path, meaning] : kFiles) text += entry(path, meaning);
    text += section("ENVIRONMENT");
    text += paragraph(
        "XDG_CACHE_HOME, XDG_CONFIG_HOME, XDG_DATA_HOME and XDG_DATA_DIRS: see FILES; relative paths in them "
        "are "
        "ignored.");
    text += section("EXAMPLES");
    for (const auto& [command, meaning] : kExamples) text += entry(command, meaning);
    return text;
}

}  // namespace rayscope::cli
