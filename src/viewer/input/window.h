#pragma once
#include <rayscope/vector.h>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace rayscope::viewer {

/// There is no display, or it has no OpenGL 3.3. what() is one sentence for the user.
struct NoDisplay : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct KeyPress {
    int key = 0;  ///< GLFW_KEY_…, letters as the keyboard layout names them
    int modifiers = 0;
};

/// The window of the desktop with its OpenGL context and the state of Dear ImGui.
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

    /// Handles events; returns at once if `seconds` is 0, else waits that long for one to come. Returns
    /// whether any came.
    bool handleEvents(double seconds);
    /// The keys pressed and the files dropped since the last call.
    std::vector<KeyPress> takeKeys() { return std::exchange(keys_, {}); }
    std::vector<std::string> takeDroppedFiles() { return std::exchange(dropped_, {}); }

    glm::ivec2 framebufferSize() const;
    /// Pixels per unit that the monitor asks for: 1 on common ones, 2 on many laptops.
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
    int windowed_[4] = {0, 0, 1280, 720};  ///< place and size to return to
};

}  // namespace rayscope::viewer
