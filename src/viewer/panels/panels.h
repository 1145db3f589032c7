#pragma once
// One function per part of the window. Each draws from the workspace and writes changes back into it.
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/view/drawing_budget.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

void drawMenuBar(Workspace& workspace);
void drawStatusBar(Workspace& workspace, float height);
void drawKeysWindow(Workspace& workspace);
void drawStatisticsWindow(Workspace& workspace);
void drawErrorDialog(Workspace& workspace);
/// Progress of a load that takes long, with a button that cancels it.
void drawLoadingWindow(Workspace& workspace);

/// The view buttons and the tabs, into the current window.
void drawSidePanelContents(Workspace& workspace);

// Groups of the side panel.
void drawScenePanel(Workspace& workspace);
void drawCameraPanel(Workspace& workspace);
void drawLightsPanel(Workspace& workspace);
void drawSettingsPanel(Workspace& workspace);
void drawRaysPanel(Workspace& workspace);
void drawBvhPanel(Workspace& workspace);
void drawHeatPanel(Workspace& workspace);
void drawLabPanel(Workspace& workspace);
void drawTradePanel(Workspace& workspace);
void drawComparisonPanel(Workspace& workspace);
void drawQualityPanel(Workspace& workspace);

/// The divider and the labels A and B of compared pictures, over the picture.
void drawComparisonMarks(const Workspace& workspace, glm::vec2 origin, glm::vec2 size);

/// What is left out while the camera moves, in the lower left corner of the picture.
void drawDetailNotice(const DrawnCounts& counts, glm::vec2 origin, glm::vec2 size);

/// A file dialog for scene files.
class OpenDialog {
  public:
    /// Opens the dialog at the next draw().
    void request() { requested_ = true; }
    void draw(Workspace& workspace);
    bool busy() const { return listing_.busy(); }

  private:
    struct Entry {
        std::string name;
        bool folder;
    };
    /// The folders and scene files in a folder.
    struct Listing {
        std::filesystem::path folder;
        std::vector<Entry> entries;
        std::string error;
    };
    static Listing list(const std::filesystem::path& folder, const std::stop_token& stop);
    /// Lists a folder in the background.
    void enter(std::filesystem::path folder);
    void takeListing();
    bool drawEntries();

    bool requested_ = false;
    Listing listed_;
    BackgroundJob<Listing> listing_;
    std::string typed_;
};

/// Size, sample count and file name of a render to a file, then its progress.
class RenderDialog {
  public:
    /// Opens the dialog at the next draw().
    void request() { requested_ = true; }
    void draw(Workspace& workspace);

  private:
    bool requested_ = false;
    void drawForm(Workspace& workspace);
    void drawProgress(Workspace& workspace);

    int size_[2] = {800, 800};
    int samples_ = 64;
    std::string path_ = "render.png";
    std::string errorMessage_;
};

}  // namespace rayscope::viewer
