#include "base/atomic_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "base/temporary_files.h"
#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::inputErrorOf;
using test::readText;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// Limits the size of files to `bytes`, like a full disk.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

  private:
    rlimit old_{};
    void (*oldHandler_)(int);
};

TEST(AtomicFile, WritesAndReplaces) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.json");
    base::writeFileAtomically(path, "one");
    EXPECT_EQ(readText(path), "one");
    base::writeFileAtomically(path, "two");
    EXPECT_EQ(readText(path), "two");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, FullDiskKeepsTheOldFileAndLeavesNoTemporary) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.json", "old");
    std::string message;
    {
        const FullDisk limit(1000);
        message = inputErrorOf([&] { base::writeFileAtomically(path, std::string(5000, 'x')); });
    }
    EXPECT_THAT(message, AllOf(HasSubstr(path), HasSubstr("cannot be written: File too large")));
    EXPECT_EQ(readText(path), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, DevicesAreWrittenDirectly) {
    base::writeFileAtomically("/dev/null", "gone");
    EXPECT_THAT(inputErrorOf([] { base::writeFileAtomically("/dev/full", "x"); }),
                HasSubstr("No space left on device"));
    struct stat status {};
    ASSERT_EQ(::stat("/dev/full", &status), 0);
    EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(AtomicFile, SymbolicLinksAreFollowed) {
    const TemporaryFolder folder;
    folder.write("target", "old");
    std::filesystem::create_symlink("target", folder.file("link"));
    base::writeFileAtomically(folder.file("link"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(readText(folder.file("target")), "new");
}

TEST(AtomicFile, KeepsThePermissionsOfTheOldFile) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.json", "old");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    base::writeFileAtomically(path, "new");
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, ErrorsSayWhyADestinationIsInvalid) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination(folder.file("no/such/a.json")); }),
                AllOf(HasSubstr("no folder"), HasSubstr("create it")));
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination(folder.path().string()); }),
                HasSubstr("is a folder"));
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination(""); }), HasSubstr("is empty"));
    const std::string file = folder.write("file", "");
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination(file + "/a.json"); }), HasSubstr("no folder"));
}

TEST(AtomicFile, UnwritableFileSystemsAreErrors) {
    EXPECT_THAT(inputErrorOf([] { base::checkFileDestination("/proc/rayscope.json"); }),
                AllOf(HasSubstr("/proc/rayscope.json"), HasSubstr("cannot be written: ")));
}

TEST(AtomicFile, UnwritableFoldersAreErrors) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write to every folder";
    const TemporaryFolder folder;
    ASSERT_EQ(::chmod(folder.path().c_str(), 0500), 0);
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination(folder.file("a.json")); }),
                HasSubstr("Permission denied"));
    ::chmod(folder.path().c_str(), 0700);
}

using Kind = base::TemporaryFile::Kind;

TEST(TemporaryFile, HasNoNameBeforeItIsMoved) {
    const TemporaryFolder folder;
    const int probe = ::open(folder.path().c_str(), O_WRONLY | O_TMPFILE, 0600);
    if (probe < 0) GTEST_SKIP() << "the file system has no files without names";
    ::close(probe);
    base::TemporaryFile file(folder.path(), 0640);
    ASSERT_EQ(::write(file.descriptor(), "new", 3), 3);
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_TRUE(file.moveTo(folder / "a"));
    EXPECT_EQ(readText(folder / "a"), "new");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(TemporaryFile, ReplacesAFileAndLeavesNothing) {
    for (const Kind kind : {Kind::UnnamedIfPossible, Kind::Named}) {
        const TemporaryFolder folder;
        folder.write("a", "old");
        base::TemporaryFile file(folder.path(), 0600, kind);
        ASSERT_EQ(::write(file.descriptor(), "new", 3), 3);
        EXPECT_EQ(readText(folder / "a"), "old");
        EXPECT_TRUE(file.moveTo(folder / "a"));
        EXPECT_EQ(readText(folder / "a"), "new");
        EXPECT_EQ(folder.entries(), 1u);
    }
}

TEST(TemporaryFile, DeletesItsNameUnlessMoved) {
    const TemporaryFolder folder;
    {
        const base::TemporaryFile file(folder.path(), 0600, Kind::Named);
        EXPECT_EQ(folder.entries(), 1u);
    }
    EXPECT_EQ(folder.entries(), 0u);
    base::TemporaryFile file(folder.path(), 0600);
    EXPECT_FALSE(file.moveTo(folder / "no" / "a"));
    EXPECT_EQ(errno, ENOENT);
}

TEST(TemporaryFile, NamesDiffer) {
    const TemporaryFolder folder;
    const base::TemporaryFile one(folder.path(), 0600, Kind::Named), two(folder.path(), 0600, Kind::Named);
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(TemporaryFile, SignalHandlersCanDeleteIt) {
    const TemporaryFolder folder;
    base::TemporaryFile file(folder.path(), 0600, Kind::Named);
    EXPECT_EQ(folder.entries(), 1u);
    base::removeTemporaryFiles();
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_FALSE(file.moveTo(folder / "a"));
}

TEST(AtomicFile, DescriptorsAreContinued) {
    const TemporaryFolder folder;
    const int descriptor = ::open(folder.file("log").c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_GE(descriptor, 0);
    ASSERT_EQ(::write(descriptor, "one ", 4), 4);
    base::writeFileAtomically("/dev/fd/" + std::to_string(descriptor), "two");
    ::close(descriptor);
    EXPECT_EQ(readText(folder / "log"), "one two");
    EXPECT_THAT(inputErrorOf([&] { base::checkFileDestination("/dev/fd/987"); }),
                HasSubstr("cannot be written"));
}

TEST(AtomicFile, PiecesAppearOnCommitOnly) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    {
        rayscope::base::AtomicFile file(folder.file("a"));
        file.write("half");
    }
    EXPECT_EQ(readText(folder / "a"), "old");
    rayscope::base::AtomicFile file(folder.file("a"));
    file.write("new ");
    file.write("text");
    EXPECT_EQ(readText(folder / "a"), "old");
    file.commit();
    EXPECT_EQ(readText(folder / "a"), "new text");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, CheckLeavesNoFile) {
    const TemporaryFolder folder;
    base::checkFileDestination(folder.file("a.json"));
    EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace rayscope
