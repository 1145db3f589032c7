#include "viewer/jobs/background_job.h"

#include <gtest/gtest.h>
#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <thread>

namespace rayscope::viewer {
namespace {

using IntJob = BackgroundJob<int>;

std::optional<int> wait(IntJob& job) {
    for (;;) {
        if (auto result = job.poll()) return result;
        if (!job.busy()) return std::nullopt;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Runs until it is stopped, and returns `result` then.
IntJob::Work untilStopped(int result) {
    return [result](const std::stop_token& stop, JobProgress&) {
        while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return result;
    };
}

TEST(BackgroundJob, deliversItsResultOnce) {
    IntJob job;
    EXPECT_FALSE(job.busy());
    job.start([](const std::stop_token&, JobProgress& progress) {
        progress.store(0.5);
        return 7;
    });
    EXPECT_TRUE(job.busy());
    EXPECT_EQ(wait(job), 7);
    EXPECT_FALSE(job.busy());
    EXPECT_EQ(job.poll(), std::nullopt);
}

#ifdef __linux__
TEST(BackgroundJob, runsWithALowerPriority) {
    const int own = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
    if (own >= 19) GTEST_SKIP() << "the test has the lowest priority itself";
    IntJob job;
    job.start([](const std::stop_token&, JobProgress&) {
        return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
    });
    EXPECT_GT(wait(job).value(), own);
    EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())), own);
}
#endif

TEST(BackgroundJob, reportsExceptionsExceptStopped) {
    IntJob job;
    job.start([](const std::stop_token&, JobProgress&) -> int { throw std::runtime_error("no memory"); });
    EXPECT_EQ(wait(job), std::nullopt);
    EXPECT_EQ(job.error(), "no memory");
    job.start([](const std::stop_token&, JobProgress&) -> int { throw Stopped(); });
    EXPECT_TRUE(job.error().empty()) << "of the latest work";
    EXPECT_EQ(wait(job), std::nullopt);
    EXPECT_TRUE(job.error().empty());
}

TEST(BackgroundJob, cancelledWorkMayStillDeliver) {
    IntJob job;
    job.start(untilStopped(3));
    job.cancel();
    EXPECT_EQ(wait(job), 3);
}

TEST(BackgroundJob, discardedWorkDoesNotDeliver) {
    IntJob job;
    job.start(untilStopped(3));
    job.discard();
    EXPECT_EQ(wait(job), std::nullopt);
    job.start([](const std::stop_token&, JobProgress&) { return 4; });
    EXPECT_EQ(wait(job), 4) << "later work does";
}

TEST(BackgroundJob, ofSeveralStartsTheLatestDelivers) {
    IntJob job;
    for (int i = 0; i < 5; ++i) job.start(untilStopped(i));
    job.start([](const std::stop_token&, JobProgress&) { return 5; });
    EXPECT_EQ(wait(job), 5);
    EXPECT_FALSE(job.busy());
}

TEST(BackgroundJob, theDestructorStopsTheWork) {
    std::atomic<bool> stopped = false;
    {
        IntJob job;
        job.start([&](const std::stop_token& stop, JobProgress&) {
            while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            stopped = true;
            return 0;
        });
    }
    EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace rayscope::viewer
