#include "base/block_reader.h"

#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace rayscope::test {
namespace {

using base::BlockReader;

class BlockReaderTest : public ::testing::Test {
  protected:
    BlockReaderTest()
        : path_((std::filesystem::temp_directory_path() / ("rayscope-blocks-" + std::to_string(::getpid())))
                    .string()) {
        for (std::size_t i = 0; i < 3 * BlockReader::kBlock + 17; ++i)
            content_.push_back(static_cast<char>(i * 7 + i / 251));
    }
    ~BlockReaderTest() override { std::filesystem::remove(path_); }
    void write() { std::ofstream(path_, std::ios::binary) << content_; }

    std::string path_, content_;
};

TEST_F(BlockReaderTest, ReturnsTheBytesInPiecesOfAnySize) {
    write();
    for (const std::size_t piece : {std::size_t{1} << 10, std::size_t{777777}, BlockReader::kBlock}) {
        BlockReader reader(path_);
        EXPECT_EQ(reader.size(), content_.size());
        std::string read;
        while (true) {
            const std::string_view bytes = reader.peek(piece);
            EXPECT_EQ(bytes.size() < piece, reader.remaining() < piece);
            if (bytes.empty()) break;
            const std::size_t count = std::min(piece, bytes.size());
            read += bytes.substr(0, count);
            reader.consume(count);
            EXPECT_EQ(reader.offset(), read.size());
        }
        EXPECT_TRUE(read == content_) << piece;
    }
}

TEST_F(BlockReaderTest, SkipsWithinTheFileOnly) {
    write();
    BlockReader reader(path_);
    EXPECT_TRUE(reader.skip(2 * BlockReader::kBlock + 3));
    EXPECT_EQ(reader.peek(1)[0], content_[2 * BlockReader::kBlock + 3]);
    EXPECT_TRUE(reader.skip(reader.remaining()));
    EXPECT_TRUE(reader.peek(1).empty());
    EXPECT_FALSE(reader.skip(1));
}

TEST_F(BlockReaderTest, ReadsPipes) {
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    std::thread writer([&] { write(); });
    BlockReader reader(path_);
    EXPECT_FALSE(reader.size());
    std::string read;
    for (std::string_view bytes = reader.peek(1); !bytes.empty(); bytes = reader.peek(1)) {
        read += bytes;
        reader.consume(bytes.size());
    }
    writer.join();
    EXPECT_TRUE(read == content_);
}

TEST_F(BlockReaderTest, ReportsFilesThatCannotBeRead) {
    EXPECT_THROW(BlockReader{path_}, InputError);
    EXPECT_THROW(BlockReader{std::filesystem::temp_directory_path().string()}, InputError);
}

}  // namespace
}  // namespace rayscope::test
