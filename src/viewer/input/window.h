#pragma once
#include <rayscope/vector.h>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace rayscope::viewer {

/// There is no display, or it has no OpenGL 3.3. what() is a message for the user.
struct NoDisplay : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct KeyPress {
    int key = 0;  ///< GLFW_KEY_…; letters by keyboard layout
    int modifiers = 0;
};

/// The desktop window with its OpenGL context and Dear ImGui.
class Window {
  public:
    Window(int width, int height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool shouldClose() const;
    void close();
    void setTitle(const std::string& title);
    void toggleFullScreen();
    bool isKeyDown(int key) const;
    void copyText(const std::string& text);

    /// Handles events, after waiting up to `seconds` for one. Returns whether there were any.
    bool handleEvents(double seconds);
    /// The keys pressed and the files dropped since the last call.
    std::vector<KeyPress> takeKeys() { return std::exchange(keys_, {}); }
    std::vector<std::string> takeDroppedFiles() { return std::exchange(dropped_, {}); }

    glm::ivec2 framebufferSize() const;
    /// UI scale for the monitor: 1 on most, 2 on many laptops.
    float contentScale() const;

    void beginFrame();
    /// Draws `behind`, then the panels over it, and shows the frame. `beforeSwap` may read the pixels.
    void endFrame(const std::function<void()>& behind, const std::function<void()>& beforeSwap);
    /// Rebuilds font and style for this scale; not between beginFrame() and endFrame().
    void applyScale(float scale);

  private:
    void installCallbacks();
    void onKey(int key, int scancode, int action, int modifiers);

    GLFWwindow* window_ = nullptr;
    std::vector<KeyPress> keys_;
    std::vector<int> downSinceFrame_;
    std::vector<KeyPress> releases_;  ///< of keys that went down since the last frame
    std::vector<std::string> dropped_;
    bool anyEvent_ = false;
    bool fullScreen_ = false;
    int windowed_[4] = {0, 0, 1280, 720};  ///< position and size outside full screen
};

}  // namespace rayscope::viewer
