#include "base/private_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::inputErrorOf;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr std::size_t kMostBytes = 100;

unsigned permissionsOf(const std::filesystem::path& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 07777;
}

TEST(PrivateFile, NobodyElseHasAccess) {
    const mode_t old = ::umask(0);
    const TemporaryFolder folder;
    base::writePrivateFile(folder.file("a/b/c"), "one");
    EXPECT_EQ(permissionsOf(folder / "a"), 0700u);
    EXPECT_EQ(permissionsOf(folder / "a/b"), 0700u);
    EXPECT_EQ(permissionsOf(folder / "a/b/c"), 0600u);
    // Also if a version that did not care has written it.
    ASSERT_EQ(::chmod(folder.file("a/b/c").c_str(), 0644), 0);
    base::writePrivateFile(folder.file("a/b/c"), "two");
    EXPECT_EQ(permissionsOf(folder / "a/b/c"), 0600u);
    EXPECT_EQ(base::readPrivateFile(folder.file("a/b/c"), kMostBytes), "two");
    ::umask(old);
}

TEST(PrivateFile, AMissingFileIsNoError) {
    const TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_EQ(base::readPrivateFile(folder.file("a/b"), kMostBytes), std::nullopt);
    EXPECT_EQ(base::readPrivateFile(folder.file("file/b"), kMostBytes), std::nullopt);
}

TEST(PrivateFile, FilesThatOthersMayHaveWrittenAreRefused) {
    const TemporaryFolder folder;
    const auto problem = [&] {
        return inputErrorOf([&] { base::readPrivateFile(folder.file("a"), kMostBytes); });
    };
    folder.write("a", "content");
    for (const mode_t mode : {0620, 0602, 0666}) {
        ASSERT_EQ(::chmod(folder.file("a").c_str(), mode), 0);
        EXPECT_THAT(problem(), HasSubstr("can be written by others"));
    }
    ASSERT_EQ(::chmod(folder.file("a").c_str(), 0644), 0);
    EXPECT_EQ(base::readPrivateFile(folder.file("a"), kMostBytes), "content");
    if (::geteuid() != 0) return;  // only root can give files away
    ASSERT_EQ(::chown(folder.file("a").c_str(), 12345, 12345), 0);
    EXPECT_THAT(problem(), HasSubstr("belongs to another user"));
}

TEST(PrivateFile, OnlyRegularFilesOfALimitedSizeAreRead) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    for (const char* name : {"pipe", "."})
        EXPECT_THAT(inputErrorOf([&] { base::readPrivateFile(folder.file(name), kMostBytes); }),
                    HasSubstr("is not a regular file"));
    folder.write("long", std::string(kMostBytes + 1, 'x'));
    EXPECT_THAT(inputErrorOf([&] { base::readPrivateFile(folder.file("long"), kMostBytes); }),
                HasSubstr("has 101 bytes, more than 100"));
}

}  // namespace
}  // namespace rayscope
