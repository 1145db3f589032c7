#include "viewer/lab_run.h"

#include <rayscope/diagnostics.h>
#include <chrono>

namespace rayscope::viewer {

void LabRun::start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads) {
    stop_.request_stop();
    if (coming_.valid()) coming_.wait();
    stop_ = std::stop_source{};
    scene_ = scene;
    result_.reset();
    problem_.clear();
    ++version_;
    fraction_ = std::make_shared<std::atomic<double>>(0.0);
    LabRequest request;
    request.scene = std::move(scene);
    request.settings = settings;
    request.quick = quick;
    request.threads = threads;
    request.stop = stop_.get_token();
    request.progress = [fraction = fraction_](double done, double) { fraction->store(done); };
    coming_ = std::async(std::launch::async, [request = std::move(request)] { return runLab(request); });
}

void LabRun::update() {
    if (!coming_.valid() || coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    ++version_;
    try {
        result_ = coming_.get();
    } catch (const std::exception& error) {
        problem_ = error.what();
    }
}

}  // namespace rayscope::viewer
