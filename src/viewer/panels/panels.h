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
/// The lens of the camera, beside the settings of depth of field.
void drawLensRows(Workspace& workspace);
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

/// Quantity, range and colours of the heat map, in the lower right corner of the picture.
void drawColorBar(const Workspace& workspace, glm::vec2 origin, glm::vec2 size);

/// A mark at the surface of the recorded pixel, or of a pinned one, in pixels of the picture.
struct PixelMark {
    glm::vec2 pixel{0.0f};
    std::string label;  ///< the number of the pin; empty for the recorded pixel
    bool recorded = false;
};
std::vector<PixelMark> pixelMarks(const Workspace& workspace);
/// `unit` is the number of pixels per unit of the window.
void drawPixelMarks(const Workspace& workspace, glm::vec2 origin, double unit);

/// The crosshair and the label while a command waits for a click on a pixel.
void drawPickingMarks(const Workspace& workspace, glm::vec2 origin, glm::vec2 size);

/// The commands for a pixel, at the cursor.
void drawContextMenu(Workspace& workspace);

/// What the traced picture is, in the upper left corner of the picture, unless it is the complete picture of
/// the current state.
void drawTracedNotice(const Workspace& workspace, glm::vec2 origin);

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
    void drawEntry(const Entry& entry, std::string& entered, bool& chosen);
    static Listing list(const std::filesystem::path& folder, const std::stop_token& stop);
    /// Lists a folder in the background.
    void enter(std::filesystem::path folder);
    void takeListing();
    bool drawEntries();

    bool requested_ = false;
    std::string selected_;  ///< name of the entry that was clicked last
    Listing listed_;
    BackgroundJob<Listing> listing_;
    std::string typed_;
};

/// Size, sample count and file name of a render to a file, then its progress. The rest of the window stays
/// usable.
class RenderWindow {
  public:
    /// Opens the window.
    void request(Workspace& workspace);
    void draw(Workspace& workspace);

  private:
    void start(Workspace& workspace);
    void drawForm(Workspace& workspace);
    void drawProgress(Workspace& workspace);
    void reportEnd(Workspace& workspace);

    bool running_ = false;     ///< in the frame before
    std::string overwritten_;  ///< the existing file that the user is asked about
    int size_[2] = {800, 800};
    int samples_ = 64;
    std::string path_ = "render.png";
    std::string errorMessage_;
};

}  // namespace rayscope::viewer
