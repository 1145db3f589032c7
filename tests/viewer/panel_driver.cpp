#include "panel_driver.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "viewer/panels/theme.h"

namespace rayscope::viewer {

namespace {

constexpr float kWidth = 1280.0f, kHeight = 3000.0f, kPanelWidth = 336.0f;

bool endsWithPath(std::string_view path, std::string_view label) {
    if (!path.ends_with(label)) return false;
    return path.size() == label.size() || path[path.size() - label.size() - 1] == '/';
}

ImVec2 centerOf(const ui::Item& item) {
    return {0.5f * (item.lower.x + item.upper.x), 0.5f * (item.lower.y + item.upper.y)};
}

EditState stateOf(const std::string& scene, const std::map<std::string, std::string>& settings) {
    Diagnostics notes;
    std::vector<SettingAssignment> assignments;
    for (const auto& [key, value] : settings) assignments.push_back({key, value, {}});
    RequestOverrides overrides;
    overrides.settings = assignments;
    return initialState(loadScene("builtin:" + scene, notes), overrides);
}

}  // namespace

PanelDriver::PanelDriver(const std::string& scene, const std::map<std::string, std::string>& settings)
    : workspace(stateOf(scene, settings), {}, 2), context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth, kHeight};
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
    applyTheme(1.0f);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ui::recordItems(true);
    ui::sections().clear();
    workspace.viewSize = {64, 48};
    frame();
    frame();
}

PanelDriver::~PanelDriver() {
    ui::recordItems(false);
    ImGui::DestroyContext(context_);
}

std::vector<Command> PanelDriver::takeCommands() { return std::exchange(workspace.commands, {}); }

void PanelDriver::frame() {
    workspace.updateTracing(false);
    const std::optional<TracedPicture> picture = workspace.render.session().picture();
    if (const auto world = workspace.worldOfScene()) workspace.bvh.update(world);
    if (workspace.view.traced && picture)
        workspace.heat.update(workspace.render.currentWorld(), picture->film(), 1);
    if (auto loaded = workspace.loader.poll()) workspace.show(std::move(*loaded));
    workspace.reportSaves();
    workspace.lab.update();
    workspace.trade.update();
    workspace.rays.update();
    workspace.rays.updateTraversal();
    workspace.rays.follow(workspace.edit, picture);

    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    ImGui::NewFrame();
    ui::beginFrame();
    drawMenuBar(workspace);
    drawStatusBar(workspace, 24.0f);
    ImGui::SetNextWindowPos({kWidth - kPanelWidth, 20.0f});
    ImGui::SetNextWindowSize({kPanelWidth, kHeight - 50.0f});
    if (ImGui::Begin("##side", nullptr, ImGuiWindowFlags_NoDecoration)) drawSidePanelContents(workspace);
    ImGui::End();
    drawKeysWindow(workspace);
    drawStatisticsWindow(workspace);
    openDialog.draw(workspace);
    renderWindow.draw(workspace);
    drawContextMenu(workspace);
    drawErrorDialog(workspace);
    drawLoadingWindow(workspace);
    drawComparisonMarks(workspace, {0.0f, 20.0f}, {900.0f, 600.0f});
    drawColorBar(workspace, {0.0f, 20.0f}, {900.0f, 600.0f});
    drawPixelMarks(workspace, {0.0f, 20.0f}, 1.0);
    drawPickingMarks(workspace, {0.0f, 20.0f}, {900.0f, 600.0f});
    drawTracedNotice(workspace, {0.0f, 20.0f});
    workspace.closeDialogs = false;
    ImGui::Render();
}

void PanelDriver::waitFor(const char* what, const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    for (frame(); !condition(); frame()) {
        if (std::chrono::steady_clock::now() > end) throw std::runtime_error(std::string("no ") + what);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    frame();
}

void PanelDriver::waitForWorld() {
    waitFor("world", [this] { return workspace.render.currentWorld() != nullptr; });
}

void PanelDriver::recordPixel(int x, int y) {
    waitForWorld();
    workspace.rays.recordPixel(*workspace.render.currentPicture(), workspace.edit.settings.spp, {x, y, 0},
                               DebugRays::Compare::WithNothing);
    waitFor("replay", [this] { return !workspace.rays.busy(); });
    workspace.rays.diagnose();
    waitFor("diagnosis", [this] { return !workspace.rays.busy(); });
}

const ui::Item* PanelDriver::find(std::string_view label, Kind kind) const {
    const ui::Item *exact = nullptr, *suffix = nullptr, *text = nullptr;
    int suffixes = 0;
    for (const ui::Item& item : ui::items()) {
        const std::string_view path = item.path;
        const std::string_view bare = path.substr(0, path.find("##"));
        for (const std::string_view candidate : {path, bare}) {
            if (!item.isText && candidate == label) exact = &item;
            if (!endsWithPath(candidate, label)) continue;
            if (item.isText) {
                text = &item;
            } else if (suffix != &item) {
                suffix = &item;
                ++suffixes;
            }
        }
    }
    if (kind == Kind::Text) return text;
    if (exact != nullptr) return exact;
    EXPECT_LE(suffixes, 1) << "several controls are called '" << label << "'";
    return suffix != nullptr ? suffix : text;
}

const ui::Item& PanelDriver::get(std::string_view label) {
    if (const ui::Item* item = find(label)) return *item;
    std::string known;
    for (const ui::Item& item : ui::items())
        if (!item.isText) known += "\n  " + item.path;
    throw std::runtime_error("no control '" + std::string(label) + "' among:" + known);
}

bool PanelDriver::has(std::string_view label) const { return find(label) != nullptr; }

bool PanelDriver::isEnabled(std::string_view label) const {
    const ui::Item* item = find(label);
    return item != nullptr && item->enabled;
}

bool PanelDriver::shows(std::string_view part) const {
    for (const ui::Item& item : ui::items())
        if (item.isText && item.path.find(part) != std::string::npos) return true;
    return false;
}

void PanelDriver::press(ImVec2 position) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = position;
    frame();
    for (const bool down : {true, false}) {
        io.MouseDown[0] = down;
        frame();
    }
}

void PanelDriver::hover(std::string_view label) {
    ImGui::GetIO().MousePos = centerOf(get(label));
    frame();
    frame();
}

void PanelDriver::click(std::string_view label) {
    press(centerOf(get(label)));
    // Long enough that the next click at this position is not a double click.
    for (int i = 0; i < 20; ++i) frame();
}

void PanelDriver::doubleClickLabel(std::string_view label) {
    const ui::Item* item = find(label, Kind::Text);
    if (item == nullptr) throw std::runtime_error("no text '" + std::string(label) + "'");
    pressTwice(centerOf(*item));
}

void PanelDriver::doubleClick(std::string_view label) { pressTwice(centerOf(get(label))); }

void PanelDriver::pressTwice(ImVec2 position) {
    press(position);
    press(position);
    for (int i = 0; i < 20; ++i) frame();
}

void PanelDriver::type(std::string_view label, const std::string& text) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = true;
    press(centerOf(get(label)));
    io.KeyCtrl = false;
    frame();
    io.AddInputCharactersUTF8(text.c_str());
    frame();
    pressEnter();
}

void PanelDriver::replaceText(std::string_view label, const std::string& text) {
    click(label);
    ImGuiIO& io = ImGui::GetIO();
    for (const bool down : {true, false}) {
        io.KeyCtrl = io.KeysDown[io.KeyMap[ImGuiKey_A]] = down;
        frame();
    }
    io.AddInputCharactersUTF8(text.c_str());
    frame();
}

void PanelDriver::pressKey(ImGuiKey key) {
    ImGuiIO& io = ImGui::GetIO();
    for (const bool down : {true, false}) {
        io.KeysDown[io.KeyMap[key]] = down;
        frame();
    }
}

void PanelDriver::choose(const std::string& row, const std::string& choice) {
    click(row);
    const std::size_t start = row.rfind('/') + 1;
    click(row.substr(start, row.find("##") - start) + "/" + choice);
}

void PanelDriver::drag(std::string_view label, float from, float to) {
    const ui::Item item = get(label);
    const auto at = [&](float fraction) {
        return ImVec2{item.lower.x + fraction * (item.upper.x - item.lower.x), centerOf(item).y};
    };
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = at(from);
    frame();
    io.MouseDown[0] = true;
    frame();
    io.MousePos = at(to);
    frame();
    io.MouseDown[0] = false;
    frame();
}

void expectToggle(PanelDriver& driver, const std::string& label, const bool& value) {
    const bool before = value;
    driver.click(label);
    EXPECT_NE(value, before) << label;
    driver.click(label);
    EXPECT_EQ(value, before) << label;
}

}  // namespace rayscope::viewer
