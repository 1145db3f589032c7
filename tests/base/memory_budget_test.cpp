#include "base/memory_budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "base/system_memory.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using testing::HasSubstr;

/// Sets a limit for its lifetime.
class ScopedLimit {
  public:
    explicit ScopedLimit(std::uint64_t bytes) : before_(memoryLimit()) { setMemoryLimit(bytes); }
    ScopedLimit(const ScopedLimit&) = delete;
    ScopedLimit& operator=(const ScopedLimit&) = delete;
    ~ScopedLimit() { setMemoryLimit(before_); }

  private:
    std::uint64_t before_;
};

constexpr std::uint64_t kGigabyte = 1'000'000'000;

template <class Action>
std::string messageOf(Action&& action) {
    try {
        action();
    } catch (const OutOfMemory& error) {
        return error.what();
    }
    return "";
}

TEST(MemoryBudget, IsByDefaultAShareOfTheMachineOrControlGroup) {
    const std::uint64_t memory = std::min(base::physicalMemory(), base::controlGroupMemory());
    EXPECT_NEAR(static_cast<double>(memoryLimit()) / static_cast<double>(memory), 0.8, 1e-6);
    EXPECT_LE(availableMemory(), memoryLimit());
}

TEST(MemoryBudget, RefusesWhatExceedsTheLimitAndSaysWhatNeedsHowMuch) {
    const ScopedLimit limit(8 * kGigabyte);
    const std::string message =
        messageOf([] { base::requireMemory(9 * kGigabyte, "fewer dots", "a grid of {} x {} dots", 30, 40); });
    EXPECT_THAT(message,
                testing::StartsWith("out of memory: a grid of 30 x 40 dots needs 9.0 GB, but only "));
    EXPECT_THAT(message, testing::EndsWith(" of 8.0 GB (the memory limit) are left; use fewer dots or a "
                                           "larger --memory-limit"));
    EXPECT_NO_THROW(base::requireMemory(2 * kGigabyte, "", "a grid"));
}

TEST(MemoryBudget, CountsWhatIsAllocatedButNotYetTouched) {
    if (base::memoryUse().allocated < 1000) GTEST_SKIP() << "the allocator does not tell what it uses";
    const std::uint64_t before = base::memoryUse().allocated;
    const ScopedLimit limit(before + kGigabyte);
    std::vector<char> untouched;
    untouched.reserve(900'000'000);
    EXPECT_GE(base::memoryUse().allocated, before + 900'000'000);
    EXPECT_NE(messageOf([] { base::requireMemory(200'000'000, "", "a second array"); }), "");
    std::vector<char>().swap(untouched);
    EXPECT_EQ(messageOf([] { base::requireMemory(200'000'000, "", "a second array"); }), "");
}

TEST(MemoryBudget, EndsWorkThatGrowsInSmallSteps) {
    EXPECT_NO_THROW(base::requireSomeMemory("reading", "less"));
    const ScopedLimit limit(1000);
    EXPECT_THAT(
        messageOf([] { base::requireSomeMemory("reading x.obj", "a smaller scene"); }),
        HasSubstr("out of memory while reading x.obj: all of 1.0 kB (the memory limit) are in use; use "
                  "a smaller scene or a larger --memory-limit"));
    std::vector<double> full(1 << 17);
    full.shrink_to_fit();
    EXPECT_NE(messageOf([&] { base::requireRoom(full, "the list", "less"); }), "");
    std::vector<double> roomy;
    roomy.reserve(1 << 17);
    EXPECT_EQ(messageOf([&] { base::requireRoom(roomy, "the list", "less"); }), "");
}

TEST(MemoryBudget, NoLimitAllowsEverythingButWhatTheSystemLimits) {
    const ScopedLimit limit(kNoMemoryLimit);
    EXPECT_NO_THROW(base::requireMemory(std::uint64_t{1} << 50, "", "everything"));
}

TEST(MemoryBudget, NamesTheWorkThatRanOutOfMemory) {
    const auto failing = []() -> int { throw std::bad_alloc(); };
    EXPECT_THAT(messageOf([&] { base::namingLackOfMemory("decoding a.exr", "a smaller image", failing); }),
                HasSubstr("out of memory while decoding a.exr; use a smaller image"));
    const auto named = []() -> int { throw OutOfMemory("out of memory: mine"); };
    EXPECT_EQ(messageOf([&] { base::namingLackOfMemory("decoding", "less", named); }), "out of memory: mine");
    EXPECT_EQ(base::namingLackOfMemory("a", "b", [] { return 7; }), 7);
    EXPECT_THROW(base::namingLackOfMemory("a", "b", []() -> int { throw std::runtime_error("other"); }),
                 std::runtime_error);
}

TEST(MemoryBudget, LongMessagesAreCut) {
    const std::string message(10'000, 'x');
    const OutOfMemory error(message);
    EXPECT_GT(std::strlen(error.what()), 300u);
    EXPECT_LT(std::strlen(error.what()), 500u);
    const OutOfMemory copy = error;
    EXPECT_STREQ(copy.what(), error.what());
}

TEST(MemoryBudget, RecognisesLackOfMemoryThatOtherLibrariesReport) {
    EXPECT_TRUE(base::reportsLackOfMemory(std::bad_alloc()));
    EXPECT_TRUE(base::reportsLackOfMemory(std::runtime_error("cannot read block: std::bad_alloc")));
    EXPECT_FALSE(base::reportsLackOfMemory(std::runtime_error("unexpected end of file")));
    EXPECT_STREQ(base::messageOf(OutOfMemory("out of memory: mine")), "out of memory: mine");
    EXPECT_THAT(base::messageOf(std::bad_alloc()), HasSubstr("out of memory; use a smaller --size"));
}

class ControlGroup : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& content) const {
        std::filesystem::create_directories((root_ / name).parent_path());
        root_.write(name, content);
    }
    std::uint64_t limit() const { return base::controlGroupMemory(root_.path()); }

  private:
    test::TemporaryFolder root_;
};

TEST_F(ControlGroup, IsUnlimitedWithoutGroups) {
    EXPECT_EQ(limit(), kNoMemoryLimit);
    write("proc/self/cgroup", "0::/user\n");
    EXPECT_EQ(limit(), kNoMemoryLimit);
    write("sys/fs/cgroup/user/memory.max", "max\n");
    EXPECT_EQ(limit(), kNoMemoryLimit);
}

TEST_F(ControlGroup, OfVersion2TakesTheSmallestLimitUpToTheRoot) {
    write("proc/self/cgroup", "0::/slice/job/step\n");
    write("sys/fs/cgroup/slice/job/step/memory.max", "max\n");
    write("sys/fs/cgroup/slice/job/memory.max", "3000000000\n");
    write("sys/fs/cgroup/slice/memory.max", "5000000000\n");
    EXPECT_EQ(limit(), 3'000'000'000u);
    // In a container the root of the hierarchy is the group itself.
    write("sys/fs/cgroup/memory.max", "1000000000\n");
    EXPECT_EQ(limit(), 1'000'000'000u);
}

TEST_F(ControlGroup, OfVersion1IsThatOfTheMemoryController) {
    write("proc/self/cgroup", "9:cpu,cpuacct:/a\n5:hugetlb,memory:/docker/b\n1:name=systemd:/c\n0::/d\n");
    write("sys/fs/cgroup/memory/docker/b/memory.limit_in_bytes", "2000000000\n");
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    write("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "1\n");
    EXPECT_EQ(limit(), 2'000'000'000u);
}

}  // namespace
}  // namespace rayscope
