#pragma once
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// Writes files in the background, one after another. All of them are written before the destructor returns.
class SaveQueue {
  public:
    SaveQueue() = default;
    ~SaveQueue();
    SaveQueue(const SaveQueue&) = delete;
    SaveQueue& operator=(const SaveQueue&) = delete;

    /// Prepares and writes the files on another thread; throws InputError.
    using Write = std::function<void()>;
    void add(std::vector<std::string> paths, Write write);

    /// The end of one entry: its files, as "a.png and b.json", and why they were not written.
    struct Outcome {
        std::string names, error;
    };
    std::optional<Outcome> poll();
    bool busy() const { return !entries_.empty(); }
    /// The files that are being written, as in Outcome; empty if there are none.
    std::string current() const;

    /// The first of rayscope-0001, rayscope-0002 … with this suffix that neither exists in the current folder
    /// nor is waiting to be written.
    std::string nextFreeName(std::string_view suffix = ".png") const;

  private:
    struct Entry {
        std::vector<std::string> paths;
        Write write;
    };
    void launch();

    std::deque<Entry> entries_;  ///< the first is being written
    BackgroundJob<bool> job_;
};

}  // namespace rayscope::viewer
