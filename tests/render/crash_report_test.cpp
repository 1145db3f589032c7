#include "render/crash_report.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <thread>

namespace rayscope {
namespace {

const render::CrashContext kContext{"a scene", "a=1", "repeat --pixel ", ",", " --sample "};

void crash(int signal, bool inAnotherThread) {
    render::installCrashReport();
    render::setCrashContext(kContext);
    const auto work = [&] { render::CurrentSample::ofThisThread().set({12, 3, 5}); };
    if (inAnotherThread)
        std::thread(work).join();
    else
        work();
    if (signal == SIGABRT) std::abort();
    std::raise(signal);
}

TEST(CrashReportDeathTest, PrintsTheCommandThatRepeatsTheSample) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(crash(SIGSEGV, false), testing::KilledBySignal(SIGSEGV),
                "segmentation fault.*scene: a scene.*settings: a=1.*this sample was being traced.*"
                "  repeat --pixel 12,3 --sample 5");
    EXPECT_EXIT(crash(SIGABRT, true), testing::KilledBySignal(SIGABRT),
                "failed assertion.*other threads were tracing.*repeat --pixel 12,3 --sample 5");
}

TEST(CrashReportDeathTest, NeedsNoContext) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(
        {
            render::installCrashReport();
            render::CurrentSample::ofThisThread().clear();
            std::raise(SIGFPE);
        },
        testing::KilledBySignal(SIGFPE), "arithmetic exception");
}

TEST(CrashReportDeathTest, UsesTheLatestContext) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(
        {
            render::installCrashReport();
            for (const char* scene : {"first", "second", "third"})
                render::setCrashContext({scene, "", "", "", ""});
            std::raise(SIGFPE);
        },
        testing::KilledBySignal(SIGFPE), "scene: third.*no sample was being traced");
}

volatile bool endless = true;

/// Overflows the stack; the use of the result prevents a tail call.
int callItself(volatile char* before) {  // NOLINT(misc-no-recursion)
    volatile char frame[4096];
    frame[0] = before ? before[0] : 'x';
    return endless ? callItself(frame) + frame[0] : 0;
}

TEST(CrashReportDeathTest, WorksAfterAStackOverflow) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(
        {
            render::installCrashReport();
            render::setCrashContext(kContext);
            std::thread([] {
                render::CurrentSample::ofThisThread().set({7, 8, 9});
                std::exit(callItself(nullptr));
            }).join();
        },
        testing::KilledBySignal(SIGSEGV),
        "segmentation fault.*this sample was being traced.*repeat --pixel 7,8 --sample 9");
}

}  // namespace
}  // namespace rayscope
