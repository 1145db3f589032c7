#include "base/read_file.h"

#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::inputErrorOf;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

TEST(ReadFile, ReturnsEveryByte) {
    const TemporaryFolder folder;
    std::string bytes;
    for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
    EXPECT_EQ(base::readFile(folder.write("a.bin", bytes)), bytes);
    EXPECT_EQ(base::readFile(folder.write("empty", "")), "");
}

TEST(ReadFile, ErrorsHaveThePathAndTheReason) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { base::readFile(folder.file("none.obj")); }),
                AllOf(HasSubstr("none.obj"), HasSubstr("No such file")));
    EXPECT_THAT(inputErrorOf([&] { base::readFile(folder.path().string()); }),
                AllOf(HasSubstr(folder.path().string()), HasSubstr("is a folder")));
}

}  // namespace
}  // namespace rayscope
