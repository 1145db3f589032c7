#include "render/crash_report.h"

#include <gtest/gtest.h>
#include <rayscope/scene.h>

#include <csignal>
#include <cstdlib>
#include <thread>

namespace rayscope {
namespace {

RenderRequest cornell() {
    Diagnostics notes;
    RenderRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene("builtin:cornell", notes));
    request.camera = request.scene->cameras.front();
    request.width = 40;
    request.height = 30;
    return request;
}

TEST(CrashReport, TheCommandNamesEverythingThatDiffers) {
    RenderRequest request = cornell();
    EXPECT_EQ(
        render::probeCommandOf(request).rfind("rayscope probe builtin:cornell --size 40x30 --look-from ", 0),
        0u);
    EXPECT_EQ(render::probeCommandOf(request).find("--set"), std::string::npos);
    request.seed = 7;
    request.settings.hardShadows = false;
    request.settings.exposure = 1.5f;
    const std::string command = render::probeCommandOf(request);
    EXPECT_NE(command.find(" --seed 7"), std::string::npos);
    EXPECT_NE(command.find(" --set hard_shadows=false"), std::string::npos);
    EXPECT_NE(command.find(" --set exposure=1.5"), std::string::npos);
}

void crash(int signal, bool inAnotherThread) {
    render::installCrashReport();
    render::describeForCrashReport(cornell());
    const auto work = [&] { render::CurrentSample::ofThisThread().set(12, 3, 5); };
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
                "segmentation fault.*scene: builtin:cornell, 40 x 30 pixels.*this sample was being traced.*"
                "rayscope probe builtin:cornell .*--pixel 12,3 --sample 5");
    EXPECT_EXIT(crash(SIGABRT, true), testing::KilledBySignal(SIGABRT),
                "assertion that failed.*settings: .*other threads were tracing.*--pixel 12,3 --sample 5");
    EXPECT_EXIT(
        {
            render::installCrashReport();
            render::CurrentSample::ofThisThread().clear();
            std::raise(SIGFPE);
        },
        testing::KilledBySignal(SIGFPE), "arithmetic exception");
}

volatile bool endless = true;

/// Calls itself until the stack is used up; the result keeps the compiler from making a loop of it.
int callItself(volatile char* before) {  // NOLINT(misc-no-recursion)
    volatile char frame[4096];
    frame[0] = before ? before[0] : 'x';
    return endless ? callItself(frame) + frame[0] : 0;
}

TEST(CrashReportDeathTest, AThreadWhoseStackIsUsedUpSaysWhatItTraced) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(
        {
            render::installCrashReport();
            render::describeForCrashReport(cornell());
            std::thread([] {
                render::CurrentSample::ofThisThread().set(7, 8, 9);
                std::exit(callItself(nullptr));
            }).join();
        },
        testing::KilledBySignal(SIGSEGV),
        "segmentation fault.*this sample was being traced.*rayscope probe builtin:cornell .*--pixel 7,8 "
        "--sample 9");
}

}  // namespace
}  // namespace rayscope
