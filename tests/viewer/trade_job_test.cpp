#include "viewer/jobs/trade_job.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "support/temporary_folder.h"

namespace rayscope::viewer {
namespace {

EditState builtin(const std::string& name) {
    Diagnostics notes;
    return initialState(loadScene("builtin:" + name, notes));
}

void waitFor(TradeJob& trade) {
    while (trade.busy()) {
        trade.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

TEST(TradeJob, MeasuresTheShownViewIncludingItsSettings) {
    const test::TemporaryFolder folder;
    setenv("XDG_CACHE_HOME", folder.file("cache").c_str(), 1);
    EditState state = builtin("cornell");
    state.settings.spp = 1;
    TradeJob trade;
    trade.budget = 4.0f;
    trade.start(state, {600, 300}, 2);
    EXPECT_TRUE(trade.busy());
    waitFor(trade);
    ASSERT_NE(trade.result(), nullptr) << trade.errorMessage();
    EXPECT_EQ(trade.result()->width, 96);
    EXPECT_EQ(trade.result()->height, 48);
    EXPECT_EQ(trade.scene(), state.scene.get());
    EXPECT_TRUE(measuredPoint(*trade.result(), state.settings));
}

TEST(TradeJob, KeepsMeasurementsAfterAStop) {
    TradeJob trade;
    trade.budget = 20.0f;
    trade.start(builtin("triangle"), {20, 20}, 1);
    // There is nothing to keep until the reference is rendered, which takes part of the budget.
    while (trade.fraction() < 0.6) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    trade.stop();
    waitFor(trade);
    ASSERT_NE(trade.result(), nullptr) << trade.errorMessage();
    EXPECT_TRUE(trade.result()->interrupted);
}

}  // namespace
}  // namespace rayscope::viewer
