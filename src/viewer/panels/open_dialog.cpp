#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include <algorithm>
#include <span>

#include "base/file_suffix.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kOpenTitle = "Open a scene";

bool isScene(const std::filesystem::path& path) {
    const std::vector<std::string> known = sceneFileSuffixes();
    return std::any_of(known.begin(), known.end(),
                       [&](const std::string& suffix) { return base::hasSuffix(path.string(), suffix); });
}

/// "a, b or c".
std::string suffixChoices() {
    const std::vector<std::string> suffixes = sceneFileSuffixes();
    const std::span first(suffixes.data(), suffixes.size() - 1);
    return fmt::format("{} or {}", fmt::join(first, ", "), suffixes.back());
}

}  // namespace

OpenDialog::Listing OpenDialog::list(const std::filesystem::path& folder, const std::stop_token& stop) {
    Listing listing{folder, {}, {}};
    std::error_code failed;
    std::filesystem::directory_iterator item(folder, failed);
    for (; !failed && item != std::filesystem::directory_iterator(); item.increment(failed)) {
        if (stop.stop_requested()) throw Stopped();
        const std::string name = item->path().filename().string();
        std::error_code ignored;
        const bool isFolder = item->is_directory(ignored);
        if (!name.starts_with(".") && (isFolder || isScene(item->path())))
            listing.entries.push_back({name, isFolder});
    }
    if (failed) listing.error = fmt::format("cannot read {}: {}", folder.string(), failed.message());
    std::sort(listing.entries.begin(), listing.entries.end(), [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    if (folder.has_parent_path() && folder != folder.root_path())
        listing.entries.insert(listing.entries.begin(), {"..", true});
    return listing;
}

void OpenDialog::enter(std::filesystem::path folder) {
    typed_ = folder.string();
    listing_.start([folder = std::move(folder)](const std::stop_token& stop, JobProgress&) {
        return list(folder, stop);
    });
}

void OpenDialog::takeListing() {
    auto listing = listing_.poll();
    if (!listing) return;
    if (!listing->error.empty()) {
        listed_.error = std::move(listing->error);
        return;
    }
    listed_ = std::move(*listing);
    selected_.clear();
}

/// A click selects, a second one on the same entry opens it or enters the folder.
void OpenDialog::drawEntry(const Entry& entry, std::string& entered, bool& chosen) {
    const std::string label = entry.folder ? entry.name + "/" : entry.name;
    if (!ui::selectable(label.c_str(), entry.name == selected_, ImGuiSelectableFlags_AllowDoubleClick))
        return;
    const bool again = entry.name == selected_ && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    selected_ = entry.name;
    typed_ = (listed_.folder / entry.name).lexically_normal().string();
    if (!again) return;
    if (entry.folder)
        entered = entry.name;
    else
        chosen = true;
}

/// Returns whether a double click has put the file to open into `typed_`.
bool OpenDialog::drawEntries() {
    std::string entered;
    bool chosen = false;
    ImGui::BeginChild("entries", {0.0f, -2.2f * ImGui::GetFrameHeightWithSpacing()}, true);
    for (const Entry& entry : listed_.entries) drawEntry(entry, entered, chosen);
    if (listed_.entries.empty() && !busy())
        dimText(fmt::format("no folders, {} files here", suffixChoices()));
    ImGui::EndChild();
    if (!entered.empty()) enter((listed_.folder / entered).lexically_normal());
    return chosen;
}

void OpenDialog::draw(Workspace& workspace) {
    takeListing();
    if (std::exchange(requested_, false)) {
        std::error_code ignored;
        enter(listed_.folder.empty() ? std::filesystem::current_path(ignored) : listed_.folder);
        ImGui::OpenPopup(kOpenTitle);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.5f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(scaled(620.0f), display.x * 0.9f), std::min(scaled(460.0f), display.y * 0.8f)},
        ImGuiCond_Appearing);
    if (!ImGui::BeginPopupModal(kOpenTitle, nullptr, ImGuiWindowFlags_NoCollapse)) return;
    const ui::Scope scope(kOpenTitle);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    bool open = ui::noted(
        "Path", ImGui::InputText("##path", &typed_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll));
    open |= drawEntries();
    if (listed_.error.empty())
        dimText(fmt::format("A file {}, or builtin:NAME. A double-click opens a file or enters a folder.",
                            suffixChoices()));
    else
        coloredText(kErrorText, listed_.error);
    open |= ui::button("Open", {scaled(90.0f), 0.0f});
    ImGui::SameLine();
    const bool cancel = ui::button("Cancel", {scaled(90.0f), 0.0f}) || workspace.closeDialogs;
    std::error_code ignored;
    if (open && std::filesystem::is_directory(typed_, ignored)) {
        enter(std::filesystem::path(typed_).lexically_normal());
    } else if (open && !typed_.empty()) {
        workspace.open(typed_);
        ImGui::CloseCurrentPopup();
    }
    if (cancel) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace rayscope::viewer
