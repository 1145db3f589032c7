// The memory of a tree and the peak of its build, from all calls of operator new.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>

#include <rayscope/accel.h>
#include "bvh/meshes.h"

namespace {

std::atomic<std::size_t> live{0}, peak{0};

/// For blocks whose size the allocator reports with the padding for alignment.
class AlignedBlocks {
  public:
    void add(const void* memory, std::size_t size) {
        const std::scoped_lock lock(mutex_);
        *std::ranges::find(blocks_, nullptr, &Block::memory) = {memory, size};
    }
    std::size_t remove(const void* memory) {
        const std::scoped_lock lock(mutex_);
        return std::exchange(*std::ranges::find(blocks_, memory, &Block::memory), {}).size;
    }

  private:
    struct Block {
        const void* memory = nullptr;
        std::size_t size = 0;
    };
    std::mutex mutex_;
    std::array<Block, 65536> blocks_;
};
AlignedBlocks alignedBlocks;

void add(std::size_t size) {
    const std::size_t now = live += size;
    std::size_t before = peak;
    while (before < now && !peak.compare_exchange_weak(before, now)) {
    }
}

void* counted(std::size_t size) {
    void* const memory = std::malloc(size);
    if (!memory) throw std::bad_alloc();
    add(malloc_usable_size(memory));
    return memory;
}

void release(void* memory) {
    if (memory) live -= malloc_usable_size(memory);
    std::free(memory);
}

void* counted(std::size_t size, std::align_val_t alignment) {
    void* memory = nullptr;
    if (posix_memalign(&memory, static_cast<std::size_t>(alignment), size) != 0) throw std::bad_alloc();
    alignedBlocks.add(memory, size);
    add(size);
    return memory;
}

void release(void* memory, std::align_val_t) {
    if (memory) live -= alignedBlocks.remove(memory);
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t a) noexcept { release(memory, a); }
void operator delete[](void* memory, std::align_val_t a) noexcept { release(memory, a); }
void operator delete(void* memory, std::size_t, std::align_val_t a) noexcept { release(memory, a); }
void operator delete[](void* memory, std::size_t, std::align_val_t a) noexcept { release(memory, a); }

namespace rayscope::test {
namespace {

struct Memory {
    double resident, peak;  ///< bytes per triangle
};

Memory memoryOf(const TestGeometry& mesh, const BuildSettings& settings) {
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const std::size_t before = live;
    peak = before;
    const Accel accel = Accel::build(mesh.input(), settings);
    const Memory memory{static_cast<double>(live - before) / triangles,
                        static_cast<double>(peak - before) / triangles};
    fmt::print("{:.0f} bytes per triangle, {:.0f} at the peak\n", memory.resident, memory.peak);
    EXPECT_NEAR(static_cast<double>(accel.bytes()) / triangles, memory.resident, 5.0);
    return memory;
}

/// Of a scanned mesh.
TEST(Memory, TreeAndBuildAreWithinBounds) {
    const TestGeometry mesh = icosphere(6, 0.3, 5);
    for (const auto& [name, builder] :
         {std::pair{"median", BvhBuilder::Median}, std::pair{"sah", BvhBuilder::Sah},
          std::pair{"sah_binned", BvhBuilder::SahBinned}, std::pair{"high", BvhBuilder::SahReinsertion}}) {
        SCOPED_TRACE(name);
        BuildSettings settings;
        settings.builder = builder;
        const Memory memory = memoryOf(mesh, settings);
        EXPECT_LE(memory.resident, 80.0);
        EXPECT_LE(memory.peak, 250.0);
    }
}

/// The SAH splits overlapping triangles rather than filling leaves.
TEST(Memory, TreesOfLongTrianglesAreWithinBounds) {
    for (const TestGeometry& mesh : {needleSphere(150, 150), soup(40000, 0.8, 3)}) {
        SCOPED_TRACE(mesh.name);
        const Memory memory = memoryOf(mesh, {});
        EXPECT_LE(memory.resident, 80.0);
        EXPECT_LE(memory.peak, 250.0);
    }
}

}  // namespace
}  // namespace rayscope::test
