#include "viewer/model/recent_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace rayscope::viewer {
namespace {

class RecentFilesTest : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::remove_all(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() /
        ("rayscope_recent_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
         ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::path file_ = folder_ / "rayscope" / "recent";
};

TEST_F(RecentFilesTest, listsTheNewestFirstWithoutDuplicates) {
    RecentFiles recent(file_);
    recent.add("/a.toml");
    recent.add("builtin:cornell");
    recent.add("/a.toml");
    EXPECT_THAT(recent.paths(), testing::ElementsAre("/a.toml", "builtin:cornell"));
}

TEST_F(RecentFilesTest, isPersistent) {
    RecentFiles(file_).add("/some where/ä.obj");
    EXPECT_THAT(RecentFiles(file_).paths(), testing::ElementsAre("/some where/ä.obj"));
}

TEST_F(RecentFilesTest, makesPathsAbsolute) {
    RecentFiles recent(file_);
    recent.add("x/../b.toml");
    EXPECT_EQ(recent.paths()[0], (std::filesystem::current_path() / "b.toml").string());
}

TEST_F(RecentFilesTest, dropsTheOldest) {
    RecentFiles recent(file_);
    for (int i = 0; i < 30; ++i) recent.add("/" + std::to_string(i));
    EXPECT_EQ(recent.paths().size(), RecentFiles::kMaxCount);
    EXPECT_EQ(recent.paths().front(), "/29");
}

TEST_F(RecentFilesTest, toleratesUnwritableFolders) {
    RecentFiles nowhere{std::filesystem::path()};
    nowhere.add("/a.toml");
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "rayscope") << "a file where a folder should be";
    RecentFiles blocked(file_);
    blocked.add("/a.toml");
    EXPECT_EQ(blocked.paths().size(), 1u);
}

}  // namespace
}  // namespace rayscope::viewer
