#include <fmt/format.h>

#include <rayscope/settings.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"

namespace rayscope::cli {

namespace {

void printText() {
    std::string_view group;
    for (const SettingInfo& info : describeSettings()) {
        if (info.group != group) fmt::print("{}{}\n", group.empty() ? "" : "\n", info.group);
        group = info.group;
        fmt::print("  {:<24} {}\n  {:<24} {}{}{}; default {}\n", info.key, info.help, "", info.values,
                   info.unit.empty() ? "" : " ", info.unit, info.defaultValue);
    }
}

void printMarkdown() {
    fmt::print("# Settings\n\nWritten by `rayscope settings --markdown`.\n");
    std::string_view group;
    for (const SettingInfo& info : describeSettings()) {
        if (info.group != group)
            fmt::print("\n## {}\n\n| setting | meaning | values | unit | default |\n|---|---|---|---|---|\n",
                       info.group);
        group = info.group;
        fmt::print("| `{}` | {} | {} | {} | {} |\n", info.key, info.help, info.values, info.unit,
                   info.defaultValue);
    }
}

void printJson() {
    constexpr const char* trades[] = {"nothing", "noise", "bias", "speed"};
    nlohmann::json list = nlohmann::json::array();
    for (const SettingInfo& info : describeSettings()) {
        nlohmann::json row = {{"name", info.key},
                              {"group", info.group},
                              {"label", info.label},
                              {"meaning", info.help},
                              {"unit", info.unit},
                              {"type", info.kind},
                              {"default", info.defaultValue},
                              {"trades", trades[static_cast<int>(info.trade)]}};
        if (info.kind == "choice") row["choices"] = info.choices;
        if (info.kind == "integer" || info.kind == "number") row["range"] = {info.lowest, info.highest};
        list.push_back(row);
    }
    fmt::print("{}\n", list.dump(2));
}

}  // namespace

void addSettingsCommand(CLI::App& program, int& exitCode) {
    auto json = std::make_shared<bool>(false), markdown = std::make_shared<bool>(false);
    CLI::App* command =
        program.add_subcommand("settings", "List every setting: name, meaning, unit, range, default");
    command->add_flag("--json", *json, "Print JSON");
    command->add_flag("--markdown", *markdown, "Print the page docs/settings.md");
    command->callback([json, markdown, &exitCode] {
        if (*json)
            printJson();
        else if (*markdown)
            printMarkdown();
        else
            printText();
        exitCode = kSuccess;
    });
}

}  // namespace rayscope::cli
