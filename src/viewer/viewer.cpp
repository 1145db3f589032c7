#include "viewer/viewer.h"

#include <fmt/format.h>

#include "viewer/app/application.h"

namespace rayscope::viewer {

int runViewer(const ViewerOptions& options) {
    constexpr int kInputError = 2;
    viewer::LoadedScene first = viewer::loadWithNotes(options.scene, false);
    if (!first.scene) {
        fmt::print(stderr, "{}\n", first.error);
        return kInputError;
    }
    try {
        viewer::Application(options, std::move(first)).run();
    } catch (const viewer::NoDisplay& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return kInputError;
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return kInputError;
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return kInputError;
    }
    return 0;
}

}  // namespace rayscope::viewer
