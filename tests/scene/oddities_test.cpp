#include "scene/oddities.h"

#include <gtest/gtest.h>

#include <string>

namespace rayscope::scene {
namespace {

TEST(Oddities, KindsBeyondTheLimitAreCountedTogether) {
    constexpr int kMost = static_cast<int>(Oddities::kMostKinds), kMore = 100000;
    Oddities oddities("a.obj");
    for (int i = 1; i <= kMost + kMore; ++i)
        oddities.add(i == kMost + 7 ? Severity::Warning : Severity::Note, "kind " + std::to_string(i), i);
    oddities.add(Severity::Note, "kind 2", 1);
    Diagnostics notes;
    oddities.report(notes);
    ASSERT_EQ(notes.size(), Oddities::kMostKinds + 1);
    EXPECT_EQ(toString(notes[0]), "a.obj:1: note: kind 1");
    EXPECT_EQ(toString(notes[1]), "a.obj:2: note: kind 2 (2 times, first here)");
    EXPECT_EQ(toString(notes.back()), "a.obj:" + std::to_string(kMost + 1) +
                                          ": warning: 100000 more messages of other kinds are left out");
}

}  // namespace
}  // namespace rayscope::scene
