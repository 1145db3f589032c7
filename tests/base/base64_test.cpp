#include "base/base64.h"

#include <gtest/gtest.h>

#include <random>

namespace rayscope::base {
namespace {

TEST(Base64, TextsOfTheSpecification) {
    const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : cases) {
        EXPECT_EQ(base64Encoded(bytes), text);
        EXPECT_EQ(base64Decoded(text), bytes);
    }
}

TEST(Base64, DecodingGivesTheEncodedBytes) {
    std::mt19937 random(3);
    for (std::size_t size = 0; size < 200; ++size) {
        std::string bytes(size, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        EXPECT_EQ(base64Decoded(base64Encoded(bytes)), bytes);
    }
}

TEST(Base64, OtherTextsAreRefused) {
    for (const char* text : {"A", "AAAAA", "Zg =", "Zm9v\n", "Zm9*"})
        EXPECT_EQ(base64Decoded(text), std::nullopt) << text;
}

}  // namespace
}  // namespace rayscope::base
