#include "viewer/viewer.h"

#include "base/console.h"
#include "viewer/app/application.h"

namespace rayscope::viewer {

int runViewer(const ViewerOptions& options) {
    constexpr int kInputError = 2;
    try {
        viewer::Application(options).run();
    } catch (const viewer::FirstSceneFailed& error) {
        base::printMessage("{}\n", error.what());
        return kInputError;
    } catch (const viewer::NoDisplay& error) {
        base::printMessage("error: {}\n", error.what());
        return kInputError;
    } catch (const InputError& error) {
        base::printMessage("{}\n", error.what());
        return kInputError;
    }
    return 0;
}

}  // namespace rayscope::viewer
