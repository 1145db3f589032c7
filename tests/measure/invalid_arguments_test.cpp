// Arguments that are out of range throw std::invalid_argument in every function of the measuring API.
#include <gtest/gtest.h>
#include <rayscope/error_target.h>
#include <rayscope/lab.h>
#include <rayscope/trade.h>

#include <limits>
#include <stdexcept>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(InvalidArguments, ErrorTarget) {
    EXPECT_THROW(renderToTarget({}), std::invalid_argument);
    ErrorTargetRequest request;
    request.render = test::squareRequest(32);
    const auto rejects = [&](auto edit) {
        ErrorTargetRequest edited = request;
        edit(edited);
        EXPECT_THROW(renderToTarget(edited), std::invalid_argument);
    };
    rejects([](ErrorTargetRequest& r) { r.target.error = kNaN; });
    rejects([](ErrorTargetRequest& r) { r.target.error = -1.0; });
    rejects([](ErrorTargetRequest& r) { r.target.confidence = kNaN; });
    rejects([](ErrorTargetRequest& r) { r.target.confidence = 2.0; });
    rejects([](ErrorTargetRequest& r) { r.maxSamples = 0; });
    rejects([](ErrorTargetRequest& r) { r.timeLimit = kNaN; });
    rejects([](ErrorTargetRequest& r) { r.render.region = PixelBounds{0, 99, 0, 99}; });
    rejects([](ErrorTargetRequest& r) { r.threads = kMaxThreads + 1; });
}

TEST(InvalidArguments, EstimateError) {
    const ErrorTarget target{.error = 0.1};
    const RgbImage image(32, 32);
    const VarianceImage small(2, 2);
    EXPECT_NO_THROW(estimateError(image, image, {0, 32, 0, 32}, target));
    EXPECT_THROW(estimateError(image, RgbImage(16, 16), {0, 16, 0, 16}, target), std::invalid_argument);
    EXPECT_THROW(estimateError(image, image, {0, 3200, 0, 3200}, target), std::invalid_argument);
    EXPECT_THROW(estimateError(image, image, {3, 3, 0, 32}, target), std::invalid_argument);
    EXPECT_THROW(estimateError(image, image, {0, 32, 0, 32}, target, &small), std::invalid_argument);
    EXPECT_THROW(estimateError(image, image, {0, 32, 0, 32}, {.error = 0.1, .confidence = kNaN}),
                 std::invalid_argument);
}

TEST(InvalidArguments, Trade) {
    EXPECT_THROW(measureTrade({}), std::invalid_argument);
    TradeRequest request;
    request.render = test::squareRequest(32);
    request.budgetSeconds = kNaN;
    EXPECT_THROW(measureTrade(request), std::invalid_argument);
    request.budgetSeconds = 1.0;
    request.extra.emplace_back("mine", Settings{.spp = 0});
    EXPECT_THROW(measureTrade(request), std::invalid_argument);
}

TEST(InvalidArguments, Lab) {
    EXPECT_THROW(runLab({}), std::invalid_argument);
    LabRequest request;
    request.scene = test::squareRequest(32).scene;
    request.quick = true;
    for (const int rays : {0, -1}) {
        request.raysPerTestPoint = rays;
        EXPECT_THROW(runLab(request), std::invalid_argument);
    }
}

}  // namespace
}  // namespace rayscope
