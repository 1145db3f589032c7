#include "viewer/input/window.h"

#include <epoxy/gl.h>
// GLFW must come after the loader.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "viewer/panels/theme.h"

namespace rayscope::viewer {

namespace {

std::string lastGlfwError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

/// Shortcuts use the letter of the keyboard layout, not the key position: Ctrl+Z is Ctrl+Z on every layout.
int letterOf(int key, int scancode) {
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
    const int letter = std::toupper(static_cast<unsigned char>(name[0]));
    return letter >= 'A' && letter <= 'Z' ? letter : key;
}

/// Scale 2 for monitors of high pixel density, even if the desktop is configured for scale 1. Implausible
/// sizes, as reported by projectors, televisions and virtual displays, are ignored. 96 pixels per inch are
/// what X servers report if they do not know the size: then a picture of 3000 pixels or more is taken for one
/// of high density.
float scaleOfPixels(GLFWmonitor* monitor) {
    constexpr int kWidePixels = 3000;
    constexpr float kMinDensity = 144.0f, kUnknownDensity = 96.0f, kMaxDensity = 400.0f, kMinWidth = 150.0f;
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    int width = 0, height = 0;
    if (mode == nullptr) return 1.0f;
    glfwGetMonitorPhysicalSize(monitor, &width, &height);
    if (static_cast<float>(width) < kMinWidth) return 1.0f;
    const float perInch = 25.4f * static_cast<float>(mode->width) / static_cast<float>(width);
    if (mode->width >= kWidePixels && std::abs(perInch - kUnknownDensity) < 1.0f) return 2.0f;
    return perInch >= kMinDensity && perInch <= kMaxDensity ? 2.0f : 1.0f;
}

Window& ownerOf(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Window::Window(int width, int height) {
    glfwSetErrorCallback(nullptr);
    if (!glfwInit())
        throw NoDisplay(
            fmt::format("cannot open a window: no display ({}); 'rayscope render SCENE -o FILE' needs none",
                        lastGlfwError()));
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(width, height, "Rayscope", nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string reason = lastGlfwError();
        glfwTerminate();
        throw NoDisplay(fmt::format(
            "cannot open a window: no OpenGL 3.3 ({}); 'rayscope render SCENE -o FILE' needs none", reason));
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);

    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
    installCallbacks();
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

/// Every event is recorded and passed on to Dear ImGui.
void Window::installCallbacks() {
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        ownerOf(w).onKey(key, scancode, action, modifiers);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) {
        ownerOf(w).anyEvent_ = true;
        ImGui_ImplGlfw_CharCallback(w, code);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
        ownerOf(w).anyEvent_ = true;
        ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
        ownerOf(w).anyEvent_ = true;
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
        ownerOf(w).anyEvent_ = true;
        ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
        ownerOf(w).anyEvent_ = true;
        ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        ownerOf(w).anyEvent_ = true;
        for (int i = 0; i < count; ++i) ownerOf(w).dropped_.emplace_back(paths[i]);
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { ownerOf(w).anyEvent_ = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { ownerOf(w).anyEvent_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { ownerOf(w).anyEvent_ = true; });
}

/// Dear ImGui reads the state of keys once per frame. The release of a key that was pressed in the same frame
/// is delayed to the next frame, so that the press is not lost.
void Window::onKey(int key, int scancode, int action, int modifiers) {
    anyEvent_ = true;
    const KeyPress press{letterOf(key, scancode), modifiers};
    if (action == GLFW_RELEASE && std::count(downSinceFrame_.begin(), downSinceFrame_.end(), key) > 0) {
        releases_.push_back({key, modifiers});
        return;
    }
    if (action != GLFW_RELEASE) {
        keys_.push_back(press);
        downSinceFrame_.push_back(key);
    }
    ImGui_ImplGlfw_KeyCallback(window_, key, scancode, action, modifiers);
}

bool Window::shouldClose() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Window::copyText(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }
bool Window::isKeyDown(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

void Window::toggleFullScreen() {
    if (fullScreen_) {
        glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], 0);
    } else {
        GLFWmonitor* monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
        if (mode == nullptr) return;
        glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
        glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    fullScreen_ = !fullScreen_;
}

bool Window::handleEvents(double seconds) {
    anyEvent_ = false;
    downSinceFrame_.clear();
    for (const KeyPress& release : std::exchange(releases_, {})) {
        ImGui_ImplGlfw_KeyCallback(window_, release.key, 0, GLFW_RELEASE, release.modifiers);
        anyEvent_ = true;
        seconds = 0.0;
    }
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return anyEvent_;
}

glm::ivec2 Window::framebufferSize() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

float Window::contentScale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max({x, 1.0f, scaleOfPixels(glfwGetPrimaryMonitor())});
}

void Window::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::endFrame(const std::function<void()>& behind, const std::function<void()>& beforeSwap) {
    ImGui::Render();
    const glm::ivec2 size = framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glClearColor(0.09f, 0.095f, 0.105f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    behind();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    beforeSwap();
    glfwSwapBuffers(window_);
}

void Window::applyScale(float scale) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    applyTheme(scale);
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

}  // namespace rayscope::viewer
