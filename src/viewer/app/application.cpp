#include "viewer/app/application.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

#include <algorithm>
#include <cmath>
#include <thread>

#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// Seconds between frames: during motion, while background work runs, and when idle.
constexpr double kMotionSeconds = 1.0 / 120.0, kRefineSeconds = 1.0 / 40.0, kQuietSeconds = 0.5;
/// Dear ImGui needs several frames after an event to show all of its effects.
constexpr int kFramesAfterEvent = 4;
/// Seconds that the window waits for its first scene before it opens without it.
constexpr double kMaxFirstWait = 0.5;

}  // namespace

Application::Application(const ViewerOptions& options)
    : firstScene_(options.scene),
      firstOverrides_(options.overrides),
      workspace_(initialState(SceneDescription{}), {}, options.threads),
      window_((openFirstScene(), options.overrides.width), options.overrides.height) {
    setScale(layout_.scale.value_or(window_.contentScale()));
    ui::sections() = layout_.sections;
    ui::selectTab(layout_.tab);
}

void Application::run() {
    const auto secondsSince = [](Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    };
    Clock::time_point before = Clock::now();
    while (!window_.shouldClose()) {
        const double pause = frameInterval();
        if (window_.handleEvents(std::max(0.0, pause - secondsSince(before))))
            framesToDraw_ = kFramesAfterEvent;
        framesToDraw_ = std::max(0, framesToDraw_ - 1);
        const double seconds = secondsSince(before);
        before = Clock::now();
        if (pause < kQuietSeconds) workspace_.frameTimes.add(seconds);
        frame(std::min(0.1, seconds));
        storeLayout(false);
    }
    storeLayout(true);
}

/// Writes a changed layout to its file, at most once in a second unless it has to be written now.
void Application::storeLayout(bool now) {
    layout_.sections = ui::sections();
    layout_.tab = ui::currentTab();
    const bool due = now || Clock::now() - storedAt_ > std::chrono::seconds(1);
    if (layout_ == storedLayout_ || !due || (ImGui::IsAnyItemActive() && !now)) return;
    writeLayout(layoutPath(), layout_);
    storedLayout_ = layout_;
    storedAt_ = Clock::now();
}

void Application::resetLayout() {
    layout_ = WindowLayout{};
    ui::sections().clear();
    ui::selectTab("Scene");
    workspace_.view.sidePanel = true;
    setScale(window_.contentScale());
}

double Application::frameInterval() const {
    if (framesToDraw_ > 0 || input_.moving() || workspace_.view.flying) return kMotionSeconds;
    const bool working = workspace_.busy() || openDialog_.busy() || !workspace_.commands.empty();
    return working ? kRefineSeconds : kQuietSeconds;
}

void Application::frame(double seconds) {
    openScenes();
    workspace_.reportSaves();
    if (appliedScale_ != workspace_.view.scale) {
        appliedScale_ = workspace_.view.scale;
        window_.applyScale(appliedScale_);
    }
    if (workspace_.job) workspace_.job->update();

    window_.beginFrame();
    ui::beginFrame();
    takeKeys();
    drawMenuBar(workspace_);
    const Layout parts = layout();
    drawStatusBar(workspace_, parts.statusHeight);
    if (workspace_.view.sidePanel) drawSidePanel(parts);
    drawKeysWindow(workspace_);
    drawStatisticsWindow(workspace_);
    openDialog_.draw(workspace_);
    renderWindow_.draw(workspace_);
    drawContextMenu(workspace_);
    drawErrorDialog(workspace_);
    drawLoadingWindow(workspace_);
    workspace_.closeDialogs = false;
    ui::writeItemMap();
    drawPicture(parts, seconds);
    commitUndoStep();
    // The picture is above the status bar.
    const ImVec2 unit = ImGui::GetIO().DisplayFramebufferScale;
    const glm::ivec2 corner(std::lround(parts.pictureOrigin.x * unit.x),
                            std::lround(parts.statusHeight * unit.y));
    const auto saveIfRequested = [&] {
        if (std::exchange(screenshotRequested_, false)) saveScreenshotNow();
    };
    window_.endFrame([&] { picture_.show(corner); }, saveIfRequested);

    const std::string title = workspace_.edit.scene->path.empty()
                                  ? "Rayscope"
                                  : fmt::format("{} - Rayscope", workspace_.edit.scene->path);
    if (title != title_) window_.setTitle(title);
    title_ = title;
}

Application::Layout Application::layout() const {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    Layout parts;
    parts.menuHeight = ImGui::GetFrameHeight();
    parts.statusHeight = ImGui::GetFontSize() + scaled(10.0f);
    const float widest = 0.6f * display.x;
    parts.panelWidth = workspace_.view.sidePanel ? std::min(scaled(layout_.panelWidth), widest) : 0.0f;
    parts.pictureOrigin = {layout_.panelOnLeft ? parts.panelWidth : 0.0f, parts.menuHeight};
    parts.pictureSize =
        glm::max(glm::vec2(display.x - parts.panelWidth, display.y - parts.menuHeight - parts.statusHeight),
                 glm::vec2(1.0f));
    return parts;
}

void Application::drawSidePanel(const Layout& parts) {
    const float x = layout_.panelOnLeft ? 0.0f : parts.pictureSize.x;
    ImGui::SetNextWindowPos({x, parts.menuHeight});
    ImGui::SetNextWindowSize({parts.panelWidth, parts.pictureSize.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNavInputs |
                                        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("##side", nullptr, kFlags)) {
        drawPanelEdge(parts);
        drawSidePanelContents(workspace_);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

/// The edge towards the picture can be dragged.
void Application::drawPanelEdge(const Layout& parts) {
    const float width = scaled(6.0f);
    const ImVec2 start = ImGui::GetCursorPos();
    ImGui::SetCursorPos({layout_.panelOnLeft ? parts.panelWidth - width : 0.0f, 0.0f});
    // Dear ImGui clips half of the padding of the window, and what is clipped cannot be grabbed.
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, false);
    ui::noted("Panel edge", ImGui::InvisibleButton("##edge", {width, parts.pictureSize.y}));
    const bool active = ImGui::IsItemActive();
    if (ImGui::IsItemHovered() || active) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                  ImGui::GetColorU32(ImGuiCol_SeparatorHovered));
    }
    ImGui::PopClipRect();
    const float wider = ImGui::GetIO().MouseDelta.x * (layout_.panelOnLeft ? 1.0f : -1.0f) / scaled(1.0f);
    if (active)
        layout_.panelWidth = std::clamp(layout_.panelWidth + wider, WindowLayout::kMinPanelWidth,
                                        WindowLayout::kMaxPanelWidth);
    ImGui::SetCursorPos(start);
}

void Application::drawPicture(const Layout& parts, double seconds) {
    const double unit = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
    const glm::dvec2 pixels = glm::round(glm::dvec2(parts.pictureSize) * unit);
    workspace_.viewSize = glm::max(glm::ivec2(pixels), glm::ivec2(1));
    input_.update(workspace_, window_, glm::dvec2(parts.pictureOrigin), unit, seconds);
    requestLiveRay();
    executeCommands();

    workspace_.updateTracing(input_.moving());
    updateJobs();
    picture_.update(workspace_, input_.hoveredHandlePart(), input_.moving());
    updateComparison();
    drawComparisonMarks(workspace_, parts.pictureOrigin, parts.pictureSize);
    drawColorBar(workspace_, parts.pictureOrigin, parts.pictureSize);
    drawPixelMarks(workspace_, parts.pictureOrigin, unit);
    drawPickingMarks(workspace_, parts.pictureOrigin, parts.pictureSize);
    drawTracedNotice(workspace_, parts.pictureOrigin);
    drawDetailNotice(picture_.counts(), parts.pictureOrigin, parts.pictureSize);
    updateCursorRadiance();
}

void Application::updateComparison() {
    const RenderControl& render = workspace_.render;
    const ShownPicture& shown = workspace_.shown;
    const bool complete = !render.busy() && !input_.moving() && !shown.computingBloom() &&
                          shown.isFull(workspace_.edit, workspace_.imageSize());
    workspace_.comparison.update(shown.displayed(), shown.revision(), complete,
                                 workspace_.edit.settings.exposure);
}

/// Starts and polls the jobs whose results are visible.
void Application::updateJobs() {
    const bool bvhVisible = std::exchange(workspace_.bvhPanelOpen, false) || workspace_.bvh.shown.any();
    const std::optional<TracedPicture> picture = workspace_.render.session().picture();
    const std::shared_ptr<const trace::World> world = workspace_.worldOfScene();
    if ((bvhVisible && world) || workspace_.bvh.busy()) workspace_.bvh.update(world);

    // While the picture is still being refined, a heat map would compete for the cores.
    const bool idle = !workspace_.render.busy() && !input_.moving();
    const std::shared_ptr<const render::Film> film = picture ? picture->film() : nullptr;
    if (workspace_.view.traced && (idle || workspace_.heat.busy()))
        workspace_.heat.update(workspace_.render.currentWorld(), film, workspace_.render.threads());

    workspace_.lab.update();
    workspace_.trade.update();

    DebugRays& rays = workspace_.rays;
    rays.update();
    rays.updateTraversal();
    rays.follow(workspace_.edit, picture);
    const bool settled = workspace_.render.status().state == RenderState::Done;
    if (picture && settled && workspace_.view.traced && !workspace_.view.liveRay) rays.verify(*picture);
}

void Application::updateCursorRadiance() {
    std::optional<CursorInfo>& cursor = workspace_.cursor;
    if (cursor && workspace_.view.traced)
        cursor->radiance = workspace_.shown.radiance(workspace_.edit, workspace_.imageSize(), cursor->pixel);
}

/// Waits for the first scene, unless it takes long: most windows then open with their scene.
void Application::openFirstScene() {
    checkOverrides(*firstOverrides_);
    SceneLoader& loader = workspace_.loader;
    for (loader.start(firstScene_, false); loader.busy() && loader.seconds() < kMaxFirstWait;) {
        if (auto loaded = loader.poll()) showLoaded(std::move(*loaded));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

void Application::openScenes() {
    for (const std::string& path : window_.takeDroppedFiles()) workspace_.open(path);
    if (auto loaded = workspace_.loader.poll()) showLoaded(std::move(*loaded));
    if (!workspace_.loader.busy()) firstOverrides_.reset();  // the first load was cancelled
}

void Application::showLoaded(LoadedScene loaded) {
    if (loaded.path != firstScene_ || !firstOverrides_) {
        firstOverrides_.reset();
        workspace_.show(std::move(loaded));
        return;
    }
    if (!loaded.scene) throw FirstSceneFailed(loaded.error);
    const std::optional<RequestOverrides> overrides = std::exchange(firstOverrides_, std::nullopt);
    workspace_.show(std::move(loaded), &*overrides);
}

void Application::takeKeys() {
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    for (const KeyPress& press : window_.takeKeys()) {
        const std::optional<Command> command = commandFor(press.key, press.modifiers);
        if (!command) continue;
        if (*command == Command::Cancel && popup) workspace_.closeDialogs = true;
        // An open text field or dialog receives the keys.
        if (ImGui::GetIO().WantTextInput || popup) continue;
        workspace_.commands.push_back(*command);
    }
}

/// A finished gesture becomes one undo step.
void Application::commitUndoStep() {
    if (!ImGui::IsAnyItemActive() && !input_.dragging() && !input_.moving()) workspace_.record();
}

}  // namespace rayscope::viewer
