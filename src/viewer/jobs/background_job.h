#pragma once
#include <rayscope/scene.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>

namespace rayscope::viewer {

/// Something that takes long on the open scene, beside the window, and brings a Result. One at a time.
template <class Result>
class BackgroundJob {
  public:
    ~BackgroundJob() { stop_.request_stop(); }

    void stop() { stop_.request_stop(); }
    /// Takes over what is ready. What was thrown leaves words in errorMessage().
    void update() {
        if (!pending_.valid() || pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return;
        ++version_;
        try {
            result_ = pending_.get();
        } catch (const std::exception& error) {
            errorMessage_ = error.what();
        }
    }

    bool busy() const { return pending_.valid(); }
    double fraction() const { return fraction_ ? fraction_->load() : 0.0; }
    const Result* result() const { return result_ ? &*result_ : nullptr; }
    /// The scene that the result is about.
    const SceneDescription* scene() const { return scene_.get(); }
    const std::string& errorMessage() const { return errorMessage_; }
    /// Grows when there is, or is no more, a result.
    int version() const { return version_; }

  protected:
    using Work = std::function<Result(const std::stop_token&, std::atomic<double>& fraction)>;
    /// Starts anew; what runs already is stopReason first.
    void start(std::shared_ptr<const SceneDescription> scene, Work work) {
        stop_.request_stop();
        if (pending_.valid()) pending_.wait();
        stop_ = std::stop_source{};
        scene_ = std::move(scene);
        result_.reset();
        errorMessage_.clear();
        ++version_;
        fraction_ = std::make_shared<std::atomic<double>>(0.0);
        pending_ = std::async(std::launch::async, [work = std::move(work), stop = stop_.get_token(),
                                                   fraction = fraction_] { return work(stop, *fraction); });
    }

  private:
    std::shared_ptr<const SceneDescription> scene_;
    std::shared_ptr<std::atomic<double>> fraction_;
    std::future<Result> pending_;
    std::stop_source stop_;
    std::optional<Result> result_;
    std::string errorMessage_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
