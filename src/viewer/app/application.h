#pragma once
#include <chrono>
#include <string>

#include "viewer/input/view_input.h"
#include "viewer/input/window.h"
#include "viewer/panels/panels.h"
#include "viewer/view/picture.h"
#include "viewer/viewer.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// Ties window, picture and panels together and runs the loop of frames.
class Application {
  public:
    Application(const ViewerOptions& options, LoadedScene first);
    void run();

  private:
    using Clock = std::chrono::steady_clock;

    /// Where the parts of the window are, in its units.
    struct Layout {
        float menuHeight = 0.0f, statusHeight = 0.0f, panelWidth = 0.0f;
        glm::vec2 pictureOrigin{0.0f}, pictureSize{1.0f};
    };

    double frameInterval() const;
    void frame(double seconds);
    Layout layout() const;
    void drawSidePanel(const Layout& layout);
    void drawPicture(const Layout& layout, double seconds);
    void openDroppedFiles();
    void takeKeys();
    void commitUndoStep();
    void updateInspectors();
    void updateCursorRadiance();
    void updateComparison();

    void execute(Command command);
    void executeDebugCommand(Command command);
    void executeAtCursor();
    void recordRays();
    void copyRays();
    void exportRays();
    void saveImage();
    void keepPicture();
    void copyPixel();
    void setScale(float scale);
    void saveScreenshotNow();

    Window window_;
    Workspace workspace_;
    Picture picture_;
    ViewInput input_;
    OpenDialog openDialog_;
    RenderDialog renderDialog_;
    float panelWidth_ = 336.0f;  ///< in units at scale 1
    float appliedScale_ = 0.0f;
    bool screenshotRequested_ = false, recordRequested_ = false;
    std::vector<Command> cursorCommands_;  ///< that wait for the cursor's place
    int framesToDraw_ = 3;                 ///< frames to draw before the loop may wait for events
    std::string title_;
};

}  // namespace rayscope::viewer
