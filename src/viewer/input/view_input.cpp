#include "viewer/input/view_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <utility>

#include "math/vectors.h"
#include "trace/world.h"
#include "viewer/model/camera_controller.h"
#include "viewer/overlay/debug_rays_overlay.h"

namespace rayscope::viewer {

namespace {

constexpr double kClickPixels = 4.0;     // largest movement between press and release of a click
constexpr double kWheelFactor = 0.88;    // of the distance, per notch
constexpr double kSettleSeconds = 0.18;  // a motion ends this long after its last event

struct SurfacePoint {
    glm::dvec3 position;
    Hit hit;
};
std::optional<SurfacePoint> surfaceAt(const trace::World& world, const ViewFrame& frame, glm::dvec2 pixel) {
    Ray ray;
    ray.origin = glm::vec3(frame.eye);
    ray.direction = glm::vec3(frame.directionThrough(pixel));
    Hit hit;
    if (!world.closestHit(ray, 0.0f, hit)) return std::nullopt;
    return SurfacePoint{glm::dvec3(ray.origin) + glm::dvec3(ray.direction) * static_cast<double>(hit.t), hit};
}

}  // namespace

bool ViewInput::moving() const {
    const Clock::time_point now = Clock::now();
    const auto recent = [&](Clock::time_point then) {
        return std::chrono::duration<double>(now - then).count() < kSettleSeconds;
    };
    return (dragging() && drag_ != Drag::Divider && !clicked_) || recent(lastWheel_) || recent(lastFlight_);
}

/// Whether the cursor is on the divider between two compared pictures.
bool ViewInput::onDivider(const Workspace& workspace, const ViewFrame& frame) const {
    constexpr double kReach = 6.0;
    const Comparison& comparison = workspace.comparison;
    if (!comparison.visible() || comparison.view.mode != CompareMode::Wipe || !workspace.view.traced ||
        workspace.heat.shown)
        return false;
    const double x = static_cast<double>(comparison.view.divider) * frame.width;
    return std::abs(cursor_.x - x) < kReach * static_cast<double>(workspace.view.scale);
}

void ViewInput::press(Workspace& workspace, const ViewFrame& frame, bool left) {
    clicked_ = true;
    rightButton_ = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    pressed_ = last_ = cursor_;
    if (left && onDivider(workspace, frame)) {
        drag_ = Drag::Divider;
    } else if (workspace.view.flying) {
        drag_ = Drag::Look;
    } else if (!left) {
        drag_ = Drag::Pan;
    } else if (handlePart_) {
        const Light& light =
            workspace.edit.scene->lights[static_cast<std::size_t>(workspace.view.selectedLight)];
        drag_ = Drag::Handle;
        dragFrame_ = frame;
        handleStart_ =
            glm::dvec3(handlePositions(light)[static_cast<std::size_t>(workspace.view.selectedHandle)]);
    } else {
        drag_ = Drag::Orbit;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !workspace.view.picking)
            workspace.commands.push_back(Command::CenterOnPixel);
    }
}

void ViewInput::dragTo(Workspace& workspace, const ViewFrame& frame) {
    if (clicked_ &&
        glm::length(cursor_ - pressed_) < kClickPixels * static_cast<double>(workspace.view.scale))
        return;
    clicked_ = false;
    const glm::dvec2 moved = (cursor_ - last_) / static_cast<double>(workspace.view.scale);
    if (moved == glm::dvec2(0.0)) return;
    CameraDescription& camera = workspace.edit.camera;
    if (drag_ == Drag::Orbit) orbit(camera, moved);
    if (drag_ == Drag::Look) look(camera, moved);
    if (drag_ == Drag::Pan) pan(camera, cursor_ - last_, frame.height);
    if (drag_ == Drag::Divider)
        workspace.comparison.view.divider =
            std::clamp(static_cast<float>(cursor_.x / frame.width), 0.0f, 1.0f);
    if (drag_ == Drag::Handle && workspace.view.selectedLight >= 0) {
        std::vector<Light> lights = workspace.edit.scene->lights;
        Light& light = lights[static_cast<std::size_t>(workspace.view.selectedLight)];
        const glm::dvec3 position = dragged(dragFrame_, handleStart_, *handlePart_, pressed_, cursor_);
        light = withHandleMoved(light, workspace.view.selectedHandle, glm::vec3(position));
        workspace.setLights(std::move(lights));
    }
    last_ = cursor_;
}

void ViewInput::release(Workspace& workspace, const ViewFrame& frame) {
    const bool clicked = std::exchange(clicked_, false);
    const Drag drag = std::exchange(drag_, Drag::None);
    if (clicked && drag == Drag::Pan && rightButton_) {
        workspace.menuPixel = workspace.cursor;
        workspace.openPixelMenu = true;
    }
    if (!clicked || drag != Drag::Orbit) return;
    if (const auto command = std::exchange(workspace.view.picking, std::nullopt)) {
        workspace.commands.push_back(*command);
        return;
    }
    if (ImGui::GetIO().KeyCtrl) {
        workspace.commands.push_back(Command::RecordRays);
        return;
    }
    if (!workspace.view.overlay) return;
    const double reach = 1.5 * handleSize(workspace.view.scale).reach;
    const auto picked = pickLight(frame, workspace.edit.scene->lights, cursor_, reach);
    workspace.view.selectedLight = picked ? picked->light : -1;
    workspace.view.selectedHandle = picked ? picked->handle : 0;
    if (!picked) pickDebugRay(workspace, frame);
}

/// A click on a recorded ray selects it, a click elsewhere clears the selection.
void ViewInput::pickDebugRay(Workspace& workspace, const ViewFrame& frame) {
    constexpr double kReach = 6.0;
    const DebugRays::PixelRecording* recording = workspace.rays.recording();
    if (recording == nullptr) return;
    const SceneBounds& bounds = workspace.edit.bounds;
    const double reach = kReach * static_cast<double>(workspace.view.scale);
    workspace.rays.select(pickRay(recording->tree(), workspace.rays.filter, frame, cursor_, reach,
                                  static_cast<float>(math::distance(bounds.lower, bounds.upper))));
}

void ViewInput::wheel(Workspace& workspace, const ViewFrame& frame, double notches) {
    if (workspace.view.flying) {
        workspace.view.flySpeed *= std::pow(1.25, notches);
        return;
    }
    glm::dvec3 anchor = pointAtFocusDepth(workspace.edit.camera, frame, cursor_);
    if (const auto world = workspace.worldOfScene())
        if (const auto surface = surfaceAt(*world, frame, cursor_)) anchor = surface->position;
    zoomToward(workspace.edit.camera, anchor, std::pow(kWheelFactor, notches));
    lastWheel_ = Clock::now();
}

/// Returns whether a key moved the camera.
bool ViewInput::fly(Workspace& workspace, const Window& window, double seconds) {
    const bool held = drag_ == Drag::Pan || drag_ == Drag::Look;
    if ((!workspace.view.flying && !held) || ImGui::GetIO().WantTextInput) return false;
    const auto axis = [&](int positive, int negative) {
        return (window.isKeyDown(positive) ? 1.0 : 0.0) - (window.isKeyDown(negative) ? 1.0 : 0.0);
    };
    const glm::dvec3 direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                               axis(GLFW_KEY_W, GLFW_KEY_S));
    if (direction == glm::dvec3(0.0)) return false;
    // While the right button is held, these keys switch from panning to looking around.
    if (drag_ == Drag::Pan) drag_ = Drag::Look;
    clicked_ = false;
    const double faster = ImGui::GetIO().KeyShift ? 4.0 : 1.0;
    walk(workspace.edit.camera, glm::normalize(direction) * (workspace.view.flySpeed * faster * seconds));
    lastFlight_ = Clock::now();
    return true;
}

void ViewInput::updateCursor(Workspace& workspace, const ViewFrame& frame, bool inside) {
    if (!inside) {
        workspace.cursor.reset();
        return;
    }
    const glm::ivec2 image = workspace.imageSize();
    const glm::dvec2 position = cursor_ * glm::dvec2(image) / glm::dvec2(frame.width, frame.height);
    CursorInfo info;
    info.pixel = glm::clamp(glm::ivec2(glm::floor(position)), glm::ivec2(0), image - 1);
    if (const auto world = workspace.worldOfScene()) {
        const ViewFrame imageFrame = viewFrame(workspace.edit.camera, image.x, image.y);
        if (const auto surface = surfaceAt(*world, imageFrame, glm::dvec2(info.pixel) + 0.5)) {
            const trace::PrimitiveLocation name = world->locatePrimitive(surface->hit.primitive);
            info.primitive = surface->hit.primitive;
            info.position = surface->position;
            info.object = objectName(*world, static_cast<int>(name.range->object));
            if (name.range->mesh != nullptr) info.triangle = static_cast<long>(name.inObject);
        }
    }
    workspace.cursor = info;
}

void ViewInput::update(Workspace& workspace, const Window& window, glm::dvec2 origin, double unit,
                       double seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::ivec2 size = workspace.viewSize;
    cursor_ = (glm::dvec2(io.MousePos.x, io.MousePos.y) - origin) * unit;
    const bool inside = cursor_.x >= 0.0 && cursor_.y >= 0.0 && cursor_.x < size.x && cursor_.y < size.y;
    const bool free = inside && !io.WantCaptureMouse;
    ViewFrame frame = viewFrame(workspace.edit.camera, size.x, size.y);

    if (drag_ != Drag::Handle) {
        handlePart_.reset();
        const int selected = workspace.view.selectedLight;
        if (free && drag_ == Drag::None && selected >= 0 && workspace.view.overlay) {
            const Light& light = workspace.edit.scene->lights[static_cast<std::size_t>(selected)];
            const glm::dvec3 center(
                handlePositions(light)[static_cast<std::size_t>(workspace.view.selectedHandle)]);
            handlePart_ = pickHandlePart(frame, center, cursor_, handleSize(workspace.view.scale));
        }
    }
    if (drag_ == Drag::Divider || (free && drag_ == Drag::None && onDivider(workspace, frame)))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (drag_ == Drag::None && free) {
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            press(workspace, frame, true);
        else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                 ImGui::IsMouseClicked(ImGuiMouseButton_Middle))
            press(workspace, frame, false);
    } else if (drag_ != Drag::None) {
        dragTo(workspace, frame);
        const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left) ||
                          ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                          ImGui::IsMouseDown(ImGuiMouseButton_Middle);
        if (!down) release(workspace, frame);
    }
    if (free && io.MouseWheel != 0.0f) wheel(workspace, frame, static_cast<double>(io.MouseWheel));
    fly(workspace, window, seconds);
    frame = viewFrame(workspace.edit.camera, size.x, size.y);
    updateCursor(workspace, frame, free || drag_ != Drag::None);
}

}  // namespace rayscope::viewer
