#pragma once
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

#include "viewer/input/view_input.h"
#include "viewer/input/window.h"
#include "viewer/model/window_layout.h"
#include "viewer/panels/panels.h"
#include "viewer/view/picture.h"
#include "viewer/viewer.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// The scene that the window was opened with cannot be loaded. what() is the complete message.
struct FirstSceneFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Connects window, picture and panels and runs the main loop.
class Application {
  public:
    /// Opens the window with the scene, or with an empty one that is replaced as soon as the scene is loaded.
    /// Throws FirstSceneFailed.
    explicit Application(const ViewerOptions& options);
    void run();

  private:
    friend struct CommandTable;
    using Clock = std::chrono::steady_clock;

    /// Positions and sizes of the parts of the window, in its units.
    struct Layout {
        float menuHeight = 0.0f, statusHeight = 0.0f, panelWidth = 0.0f;
        glm::vec2 pictureOrigin{0.0f}, pictureSize{1.0f};
    };

    double frameInterval() const;
    void frame(double seconds);
    Layout layout() const;
    void drawSidePanel(const Layout& layout);
    void drawPanelEdge(const Layout& layout);
    void storeLayout(bool now);
    void resetLayout();
    void chooseScale(float scale);
    void drawPicture(const Layout& layout, double seconds);
    void openFirstScene();
    void openScenes();
    void showLoaded(LoadedScene loaded);
    void takeKeys();
    void commitUndoStep();
    void updateJobs();
    void updateCursorRadiance();
    void updateComparison();

    void requestLiveRay();
    void executeCommands();
    // Functions of commands.
    void recordRays();
    void copyRays();
    void exportRays();
    void saveImage();
    void copyPixel();
    void copyCamera();
    void frameScene();
    void setScale(float scale);
    void saveScreenshotNow();
    ImageMetadata rasterMetadata() const;
    void savePixels(const std::string& path, FramebufferPixels pixels, const ImageMetadata& metadata);

    std::string firstScene_;
    std::optional<RequestOverrides> firstOverrides_;  ///< until the first scene is shown
    Workspace workspace_;
    Window window_;
    Picture picture_;
    ViewInput input_;
    OpenDialog openDialog_;
    RenderWindow renderWindow_;
    WindowLayout layout_ = readLayout(layoutPath());
    WindowLayout storedLayout_ = layout_;
    Clock::time_point storedAt_{};
    float appliedScale_ = 0.0f;
    bool screenshotRequested_ = false;  ///< of this frame, once it is drawn
    int framesToDraw_ = 3;              ///< without waiting for events
    std::string title_;
};

}  // namespace rayscope::viewer
