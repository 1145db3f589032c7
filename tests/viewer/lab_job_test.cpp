#include "viewer/jobs/lab_job.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "scene/generate/generate.h"
#include "viewer/overlay/lab_overlay.h"

namespace rayscope::viewer {
namespace {

std::shared_ptr<const SceneDescription> boxAt(const glm::vec3& position) {
    auto scene = std::make_shared<SceneDescription>();
    scene->materials.emplace_back();
    scene->meshes.push_back({.name = "box",
                             .data = std::make_shared<MeshData>(scene::generate(scene::BoxShape{})),
                             .materials = {0}});
    scene->meshes[0].transform.translate = position;
    return scene;
}

void waitFor(LabJob& lab) {
    while (lab.busy()) {
        lab.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

TEST(LabJob, DeliversItsResultAndDrawsFailuresInTheScene) {
    LabJob lab;
    const glm::vec3 position(5, -3, 2);
    lab.start(boxAt(position), {}, 2);
    const int before = lab.version();
    waitFor(lab);
    ASSERT_NE(lab.result(), nullptr);
    EXPECT_GT(lab.version(), before);
    const OverlayLines lines = labFailureLines(*lab.result(), LabMethod::Float);
    EXPECT_GT(lines.size(), 100u);
    // Rays of all test points start at most a thousand box sizes away, most of them within three.
    std::size_t near = 0;
    for (const OverlayLine& line : lines) {
        ASSERT_TRUE(std::isfinite(line.from.x) && std::isfinite(line.to.z));
        const float away = glm::distance(line.from, position) / static_cast<float>(lab.result()->size);
        EXPECT_LT(away, 1100.0f);
        near += away < 3.5f;
    }
    EXPECT_GT(near, lines.size() * 2 / 3);
    EXPECT_TRUE(labFailureLines(*lab.result(), LabMethod::Rayscope).empty());
}

TEST(LabJob, StopsAndReportsErrors) {
    LabJob lab;
    lab.quick = false;
    lab.start(boxAt({}), {}, 1);
    lab.stop();
    waitFor(lab);
    ASSERT_NE(lab.result(), nullptr);
    EXPECT_TRUE(lab.result()->interrupted);
    lab.start(std::make_shared<SceneDescription>(), {}, 1);
    waitFor(lab);
    EXPECT_EQ(lab.result(), nullptr);
    EXPECT_NE(lab.errorMessage().find("needs triangles"), std::string::npos);
}

}  // namespace
}  // namespace rayscope::viewer
