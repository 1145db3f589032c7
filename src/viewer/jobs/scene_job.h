#pragma once
#include <rayscope/scene.h>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// A background job on the open scene that keeps its latest result.
template <class Result>
class SceneJob {
  public:
    /// Ends the job early; what it measured so far becomes the result.
    void stop() { job_.cancel(); }
    /// To be called in each frame.
    void update() {
        const bool wasBusy = job_.busy();
        if (auto arrived = job_.poll()) result_ = std::move(arrived);
        if (wasBusy && !job_.busy()) ++version_;
    }

    bool busy() const { return job_.busy(); }
    double fraction() const { return job_.progress(); }
    const Result* result() const { return result_ ? &*result_ : nullptr; }
    /// The scene that the result is about.
    const SceneDescription* scene() const { return scene_.get(); }
    const std::string& errorMessage() const { return job_.error(); }
    /// Increases whenever result() changes.
    int version() const { return version_; }

  protected:
    using Work = typename BackgroundJob<Result>::Work;
    void start(std::shared_ptr<const SceneDescription> scene, Work work) {
        scene_ = std::move(scene);
        result_.reset();
        ++version_;
        job_.start(std::move(work));
    }

  private:
    BackgroundJob<Result> job_;
    std::shared_ptr<const SceneDescription> scene_;
    std::optional<Result> result_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
