#pragma once
#include <rayscope/lab.h>
#include <atomic>
#include <future>
#include <memory>
#include <optional>

namespace rayscope::viewer {

/// The laboratory on the open scene, beside the window.
class LabRun {
  public:
    ~LabRun() { stop_.request_stop(); }

    bool quick = true, overlay = true;
    LabMethod shownMethod = LabMethod::Float;  ///< whose failures are drawn

    /// Starts anew; what runs already is stopped first.
    void start(std::shared_ptr<const SceneDescription> scene, const Settings& settings, int threads);
    void stop() { stop_.request_stop(); }
    /// Takes over what is ready. A scene that cannot be tried leaves words in problem().
    void update();

    bool busy() const { return coming_.valid(); }
    double fraction() const { return fraction_ ? fraction_->load() : 0.0; }
    const LabResult* result() const { return result_ ? &*result_ : nullptr; }
    /// The scene that the result is about.
    const SceneDescription* scene() const { return scene_.get(); }
    const std::string& problem() const { return problem_; }
    /// Grows when what the overlay shows may have become another.
    int version() const { return version_; }

  private:
    std::shared_ptr<const SceneDescription> scene_;
    std::shared_ptr<std::atomic<double>> fraction_;
    std::future<LabResult> coming_;
    std::stop_source stop_;
    std::optional<LabResult> result_;
    std::string problem_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
