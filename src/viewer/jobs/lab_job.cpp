#include "viewer/jobs/lab_job.h"

namespace rayscope::viewer {

void LabJob::start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads) {
    LabRequest request;
    request.scene = scene;
    request.settings = settings;
    request.quick = quick;
    request.threads = threads;
    SceneJob::start(std::move(scene), [request](const std::stop_token& stop, JobProgress& progress) {
        LabRequest run = request;
        run.stop = stop;
        run.progress = [&progress](double fraction, double) { progress.store(fraction); };
        return runLab(run);
    });
}

}  // namespace rayscope::viewer
