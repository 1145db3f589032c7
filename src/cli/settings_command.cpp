#include <fmt/format.h>

#include <rayscope/settings.h>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/json_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"

namespace rayscope::cli {

namespace {

struct SettingsOptions {
    bool json = false, markdown = false;
};

void printText() {
    std::string_view group;
    for (const SettingInfo& info : describeSettings()) {
        if (info.group != group) base::print("{}{}\n", group.empty() ? "" : "\n", info.group);
        group = info.group;
        base::print("  {:<24} {}\n  {:<24} {}{}{}; default {}\n", info.key, info.help, "", info.values,
                    info.unit.empty() ? "" : " ", info.unit, info.defaultValue);
    }
}

void printMarkdown() {
    base::print("# Settings\n\nWritten by `rayscope settings --markdown`.\n");
    std::string_view group;
    for (const SettingInfo& info : describeSettings()) {
        if (info.group != group)
            base::print("\n## {}\n\n| setting | meaning | values | unit | default |\n|---|---|---|---|---|\n",
                        info.group);
        group = info.group;
        base::print("| `{}` | {} | {} | {} | {} |\n", info.key, info.help, info.values, info.unit,
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
    base::writeOutput(base::jsonText(list));
}

}  // namespace

std::function<int()> setUpSettings(OptionList& list) {
    auto options = std::make_shared<SettingsOptions>();
    list.add("--json", &options->json, "Print JSON");
    list.add("--markdown", &options->markdown, "Print the page docs/settings.md");
    return [options] {
        if (options->json)
            printJson();
        else if (options->markdown)
            printMarkdown();
        else
            printText();
        return kSuccess;
    };
}

}  // namespace rayscope::cli
