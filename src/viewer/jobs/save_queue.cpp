#include "viewer/jobs/save_queue.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

namespace rayscope::viewer {

SaveQueue::~SaveQueue() {
    while (busy())
        if (!poll()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void SaveQueue::add(std::vector<std::string> paths, Write write) {
    entries_.push_back({std::move(paths), std::move(write)});
    if (entries_.size() == 1) launch();
}

void SaveQueue::launch() {
    job_.start([write = std::move(entries_.front().write)](const std::stop_token&, JobProgress&) {
        write();
        return true;
    });
}

std::optional<SaveQueue::Outcome> SaveQueue::poll() {
    if (entries_.empty()) return std::nullopt;
    if (!job_.poll() && job_.busy()) return std::nullopt;
    Outcome outcome{current(), job_.error()};
    entries_.pop_front();
    if (!entries_.empty()) launch();
    return outcome;
}

std::string SaveQueue::current() const {
    if (entries_.empty()) return "";
    return fmt::format("{}", fmt::join(entries_.front().paths, " and "));
}

std::string SaveQueue::nextFreeName(std::string_view suffix) const {
    for (int number = 1;; ++number) {
        const std::string name = fmt::format("rayscope-{:04}{}", number, suffix);
        std::error_code ignored;
        const bool isTaken =
            std::filesystem::exists(name, ignored) || std::ranges::any_of(entries_, [&](const Entry& entry) {
                return std::ranges::find(entry.paths, name) != entry.paths.end();
            });
        if (!isTaken) return name;
    }
}

}  // namespace rayscope::viewer
