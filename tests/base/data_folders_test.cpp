#include "base/data_folders.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "base/user_folders.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

namespace fs = std::filesystem;

/// A variable of the environment; the destructor restores the previous value.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* const previous = std::getenv(name)) previous_ = previous;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { previous_ ? ::setenv(name_, previous_->c_str(), 1) : ::unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> previous_;
};

TEST(DataFolders, BeginWithThoseOfTheProgramAndContinueWithThoseOfTheUser) {
    const Variable home("HOME", "/people/a"), user("XDG_DATA_HOME", "relative"), dirs("XDG_DATA_DIRS", "");
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
    const std::vector<fs::path> expected{program / "share/rayscope", program.parent_path() / "share/rayscope",
                                         "/people/a/.local/share/rayscope", "/usr/local/share/rayscope",
                                         "/usr/share/rayscope"};
    EXPECT_EQ(base::dataFolders(), expected);
}

TEST(DataFolders, RelativeEntriesOfTheListAreIgnored) {
    const Variable home("HOME", ""), user("XDG_DATA_HOME", "/data"), dirs("XDG_DATA_DIRS", "x:/a::./b:/c/:");
    const std::vector<fs::path> folders = base::dataFolders();
    ASSERT_EQ(folders.size(), 5u);
    EXPECT_EQ(folders[2], "/data/rayscope");
    EXPECT_EQ(folders[3], "/a/rayscope");
    EXPECT_EQ(folders[4], "/c/rayscope");
    const Variable relativeOnly("XDG_DATA_DIRS", "x:y");
    EXPECT_EQ(base::dataFolders().size(), 3u);
}

TEST(DataFolders, TheFirstFolderWithTheFileIsFound) {
    const test::TemporaryFolder folder;
    const Variable user("XDG_DATA_HOME", (folder / "user").string());
    const Variable dirs("XDG_DATA_DIRS", (folder / "system").string());
    for (const char* const name : {"system/rayscope/scenes", "user/rayscope/scenes/file.obj"})
        fs::create_directories(folder / name);
    EXPECT_EQ(base::findDataFile("scenes/file.obj"), "");  // one is missing, the other a folder
    folder.write("system/rayscope/scenes/file.obj", "v 0 0 0\n");
    EXPECT_EQ(base::findDataFile("scenes/file.obj"), folder / "system/rayscope/scenes/file.obj");
    fs::remove(folder / "user/rayscope/scenes/file.obj");
    folder.write("user/rayscope/scenes/file.obj", "v 0 0 0\n");
    EXPECT_EQ(base::findDataFile("scenes/file.obj"), folder / "user/rayscope/scenes/file.obj");
}

}  // namespace
}  // namespace rayscope
