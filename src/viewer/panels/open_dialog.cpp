#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include <algorithm>

#include "base/file_suffix.h"
#include "scene/mesh_files/read_mesh_file.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kOpenTitle = "Open a scene";

bool isScene(const std::filesystem::path& path) {
    return base::hasSuffix(path.string(), ".toml") || scene::isMeshFileName(path.string());
}

}  // namespace

void OpenDialog::enter(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::directory_iterator list(folder, failed);
    if (failed) {
        errorMessage_ = fmt::format("cannot read {}: {}", folder.string(), failed.message());
        return;
    }
    errorMessage_.clear();
    folder_ = folder;
    typed_ = folder.string();
    entries_.clear();
    for (const auto& item : list) {
        const std::string name = item.path().filename().string();
        std::error_code ignored;
        const bool isFolder = item.is_directory(ignored);
        if (!name.starts_with(".") && (isFolder || isScene(item.path())))
            entries_.push_back({name, isFolder});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    if (folder_.has_parent_path() && folder_ != folder_.root_path())
        entries_.insert(entries_.begin(), {"..", true});
}

/// Returns whether a double click has put the file to open into `typed_`.
bool OpenDialog::drawEntries() {
    std::string entered;
    bool chosen = false;
    ImGui::BeginChild("entries", {0.0f, -2.2f * ImGui::GetFrameHeightWithSpacing()}, true);
    for (const Entry& entry : entries_) {
        const std::string label = entry.folder ? entry.name + "/" : entry.name;
        if (!ui::selectable(label.c_str(), false, ImGuiSelectableFlags_AllowDoubleClick)) continue;
        if (entry.folder) {
            entered = entry.name;
        } else {
            typed_ = (folder_ / entry.name).string();
            chosen = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
    }
    if (entries_.empty()) dimText("no folders, scenes or meshes here");
    ImGui::EndChild();
    if (!entered.empty()) enter((folder_ / entered).lexically_normal());
    return chosen;
}

void OpenDialog::draw(Workspace& workspace) {
    if (std::exchange(requested_, false)) {
        std::error_code ignored;
        enter(folder_.empty() ? std::filesystem::current_path(ignored) : folder_);
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
    if (errorMessage_.empty())
        dimText(fmt::format("A scene (.toml), a mesh ({}) or builtin:NAME. Double-click to open.",
                            scene::meshFileSuffixes()));
    else
        coloredText(kErrorText, errorMessage_);
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
