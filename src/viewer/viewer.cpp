#include "viewer/viewer.h"

#include <fmt/format.h>

#include "viewer/app/application.h"

namespace rayscope::viewer {

int runViewer(const ViewerOptions& options) {
    constexpr int kInputError = 2;
    try {
        viewer::Application(options).run();
    } catch (const viewer::FirstSceneFailed& error) {
        fmt::print(stderr, "{}\n", error.what());
        return kInputError;
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
