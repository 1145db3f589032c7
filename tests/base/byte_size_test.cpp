#include "base/byte_size.h"

#include <gtest/gtest.h>

namespace rayscope {
namespace {

TEST(ByteSize, IsShownInPowersOfAThousand) {
    EXPECT_EQ(base::byteSizeText(0), "0 bytes");
    EXPECT_EQ(base::byteSizeText(999), "999 bytes");
    EXPECT_EQ(base::byteSizeText(1000), "1.0 kB");
    EXPECT_EQ(base::byteSizeText(9'949), "9.9 kB");
    EXPECT_EQ(base::byteSizeText(9'951), "10 kB");
    EXPECT_EQ(base::byteSizeText(999'499), "999 kB");
    EXPECT_EQ(base::byteSizeText(999'600), "1.0 MB");
    EXPECT_EQ(base::byteSizeText(8'589'934'592), "8.6 GB");
    EXPECT_EQ(base::byteSizeText(~std::uint64_t{0}), "18 EB");
}

TEST(ByteSize, IsReadWithDecimalAndBinaryUnits) {
    for (const auto& [text, bytes] : {std::pair{"500M", 500.0 * 1048576.0},
                                      {"500MiB", 500.0 * 1048576.0},
                                      {"500MB", 500e6},
                                      {"1.5GB", 1.5e9},
                                      {"2 g", 2147483648.0},
                                      {"0.5k", 512.0},
                                      {"3t", 3.0 * 1099511627776.0},
                                      {"1tb", 1e12}}) {
        ASSERT_TRUE(base::parseByteSize(text)) << text;
        EXPECT_EQ(static_cast<double>(*base::parseByteSize(text)), bytes) << text;
    }
}

TEST(ByteSize, RefusesEverythingElse) {
    for (const char* text : {"", "500", "M", "-1M", "1.2.3M", "1Mi", "1MBB", "1X", "1 000M", "nanM", "infG",
                             "0M", "99999999T", "1e3M", "M500", " 5M", "5M ", "5  M"})
        EXPECT_FALSE(base::parseByteSize(text)) << text;
}

}  // namespace
}  // namespace rayscope
