#pragma once
// The state that panels show and change. It has no window and draws nothing.
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/jobs/bvh_inspector.h"
#include "viewer/jobs/comparison.h"
#include "viewer/jobs/debug_rays.h"
#include "viewer/jobs/export.h"
#include "viewer/jobs/heat_map.h"
#include "viewer/jobs/lab_job.h"
#include "viewer/jobs/render_control.h"
#include "viewer/jobs/save_queue.h"
#include "viewer/jobs/scene_loader.h"
#include "viewer/jobs/shown_picture.h"
#include "viewer/jobs/trade_job.h"
#include "viewer/model/edit_state.h"
#include "viewer/model/frame_times.h"
#include "viewer/model/history.h"
#include "viewer/model/recent_files.h"
#include "viewer/workspace/commands.h"

namespace rayscope::viewer {

/// How the scene is viewed; not subject to undo.
struct ViewState {
    bool traced = false, overlay = true, sidePanel = true, flying = false, liveRay = false;
    bool showKeys = false, showStatistics = false, showRenderWindow = false;
    std::optional<Command> picking;  ///< waits for a click on a pixel
    bool wireframe = false;          ///< in the rasterised view
    float resolution = 1.0f;         ///< pixels of the traced image per pixel of the view
    double flySpeed = 1.0;           ///< scene units per second
    int selectedLight = -1, selectedHandle = 0;
    float scale = 1.0f;  ///< of the user interface
};

/// The pixel under the cursor and what it shows.
struct CursorInfo {
    glm::ivec2 pixel{0};  ///< of the traced image
    std::optional<Rgb> radiance;
    std::optional<glm::dvec3> position;      ///< of the surface
    std::string object;                      ///< its name in the scene; empty if nothing is hit
    std::uint32_t primitive = kNoPrimitive;  ///< of the world
    long triangle = -1;                      ///< within the object; -1 for a sphere
};

struct Notice {
    std::string text;
    Severity severity = Severity::Note;
    std::chrono::steady_clock::time_point at = std::chrono::steady_clock::now();
};

struct Workspace {
    Workspace(EditState first, Diagnostics firstNotes, int threads);

    EditState edit;
    History history;
    Diagnostics sceneNotes;
    ViewState view;
    RenderControl render;
    ShownPicture shown;
    DebugRays rays;
    BvhInspector bvh;
    HeatMap heat;
    LabJob lab;
    TradeJob trade;
    Comparison comparison;
    StopCriteria stopCriteria;
    bool bvhPanelOpen = false;  ///< the BVH panel was drawn in this frame
    SceneLoader loader;
    SaveQueue saves;
    RecentFiles recent{recentFilesPath()};
    std::unique_ptr<RenderJob> job;
    FrameTimes frameTimes;

    std::optional<CursorInfo> cursor;     ///< absent outside the picture
    std::optional<CursorInfo> picked;     ///< what the commands of this frame act on instead of `cursor`
    std::optional<CursorInfo> menuPixel;  ///< of the context menu
    bool openPixelMenu = false;           ///< in the next frame
    std::optional<Notice> notice;         ///< in the status bar
    std::string errorMessage;             ///< of the error dialog; empty: none
    glm::ivec2 viewSize{1};               ///< of the picture area, in pixels

    /// Commands from keys, menus and panels, executed once per frame.
    std::vector<Command> commands;
    bool closeDialogs = false;  ///< in this frame, because of the Cancel key
    /// Whether the command has to wait for a click on a pixel, because it needs one and the cursor is
    /// elsewhere.
    bool awaitPixel(const CommandInfo& info);

    glm::ivec2 imageSize() const;
    /// The world of the current scene, perhaps compiled for another camera or other settings; null until it
    /// is compiled.
    std::shared_ptr<const trace::World> worldOfScene() const;
    /// Whether any background work runs, so that frames have to follow one another.
    bool busy() const;
    /// Requirements of the scene with the lens of the current camera; computed once per scene.
    const SceneRequirements& needs();
    void notify(std::string text, Severity severity = Severity::Note);
    void setLights(std::vector<Light> lights);
    void open(const std::string& path) { loader.start(path, false); }
    /// Ends a load; the open scene stays.
    void cancelLoading();
    /// Opens the loaded scene or reports its error. With `overrides` of the command line it becomes the first
    /// state, which nothing can undo; throws InputError if they do not fit to the scene.
    void show(LoadedScene loaded, const RequestOverrides* overrides = nullptr);
    /// Reports the end of files that were saved.
    void reportSaves();
    /// Makes the current state an undo step, if it is another one.
    void record();
    bool canUndo() const { return raysStepIsLast(undoneByUndo_) || history.canUndo(); }
    bool canRedo() const { return raysStepIsLast(undoneByRedo_) || history.canRedo(); }
    void undo();
    void redo();
    // Undoable changes of the recorded rays.
    void clearRays();
    void hideSelectedRay();
    void showAllRays();

    /// Traces the current state: decides what is rendered and takes over what was traced. To be called once
    /// per frame.
    void updateTracing(bool moving);
    /// Keeps the traced picture as A. Previews and pictures of other states are not kept: a notice says so.
    void keepPicture();
    /// Writes the traced picture to a file, in the background; not a preview, as above.
    void saveTracedPicture(const std::string& path);
    /// Writes the current state as a scene file with a new name in the current folder, in the background.
    void saveEditedScene();

  private:
    /// A change of the recorded rays, after the step of the history with this number.
    struct RaysStep {
        std::size_t position;
        DebugRays::Shown other;  ///< before the change, or after it once it is undone
    };
    using RaysSteps = std::vector<RaysStep>;
    static constexpr std::size_t kMaxRaysSteps = 20;

    bool raysStepIsLast(const RaysSteps& steps) const;
    void changeRays(DebugRays::Shown wanted);
    void exchangeRays(RaysSteps& from, RaysSteps& to);

    RaysSteps undoneByUndo_, undoneByRedo_;

    std::optional<StillPicture> fullPicture();

    std::shared_ptr<const SceneDescription> requirementsScene_;
    SceneRequirements requirements_;
};

/// What the traced picture in the view is, unless it is not shown or the complete picture of the current
/// state; see noticeOf().
std::string tracedNotice(const Workspace& workspace);

}  // namespace rayscope::viewer
