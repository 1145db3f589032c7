#include "base/big_vector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace rayscope {
namespace {

bool isAligned(const void* memory, std::uintptr_t to) {
    return reinterpret_cast<std::uintptr_t>(memory) % to == 0;
}

TEST(BigVector, KeepsElementsWhileGrowingPastHugePages) {
    base::BigVector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < 3'000'000; ++i) numbers.push_back(i);
    const base::BigVector<std::uint32_t> copy = numbers;
    numbers.resize(100);
    numbers.shrink_to_fit();
    for (std::uint32_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i);
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0u), 4950u);
}

TEST(BigVector, IsAlignedToCacheLinesOrHugePages) {
    for (const std::size_t size : {1u, 63u, 4096u, 1000000u, 1834999u}) {
        const base::BigVector<char> bytes(size);
        EXPECT_TRUE(isAligned(bytes.data(), 64)) << size;
    }
    for (const std::size_t size : {1835008u, 2097152u, 2097153u, 9999999u}) {
        base::BigVector<char> bytes(size);
        EXPECT_TRUE(isAligned(bytes.data(), 2u << 20)) << size;
        bytes.front() = bytes.back() = 'x';
    }
}

struct WithDefault {
    int value = 7;
};

TEST(BigVector, RunsNonTrivialConstructors) {
    base::BigVector<WithDefault> some(5);
    some.resize(9);
    for (const WithDefault& each : some) EXPECT_EQ(each.value, 7);
    const base::BigVector<int> filled(1000, 3);
    EXPECT_EQ(std::accumulate(filled.begin(), filled.end(), 0), 3000);
}

TEST(BigVector, ThrowsBeyondTheAddressSpace) {
    base::BigVector<std::uint64_t> numbers(4, 1u);
    EXPECT_THROW(numbers.resize(std::size_t{1} << 62), std::length_error);
    EXPECT_EQ(numbers, base::BigVector<std::uint64_t>(4, 1u));
}

}  // namespace
}  // namespace rayscope
