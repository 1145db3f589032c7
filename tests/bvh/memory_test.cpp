// What a tree takes in memory, and what building it takes on the way: every operator new is counted.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <utility>

#include <rayscope/accel.h>
#include "bvh/meshes.h"

namespace {

std::atomic<std::size_t> live{0}, peak{0};

void* counted(void* memory) {
    if (!memory) throw std::bad_alloc();
    const std::size_t now = live += malloc_usable_size(memory);
    std::size_t before = peak;
    while (before < now && !peak.compare_exchange_weak(before, now)) {
    }
    return memory;
}

void release(void* memory) {
    if (memory) live -= malloc_usable_size(memory);
    std::free(memory);
}

void* aligned(std::size_t size, std::align_val_t alignment) {
    const auto a = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new[](std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) { return aligned(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return aligned(size, alignment); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace rayscope::test {
namespace {

/// Of a scan, so without the slivers that leave leaves half empty.
TEST(Memory, OfATreeAndOfItsBuildStaysInItsBounds) {
    const Geometry mesh = icosphere(6, 0.3, 5);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    for (const auto& [name, builder] :
         {std::pair{"median", BvhBuilder::Median}, std::pair{"sah", BvhBuilder::Sah},
          std::pair{"sah_binned", BvhBuilder::SahBinned}, std::pair{"high", BvhBuilder::High}}) {
        BuildSettings settings;
        settings.builder = builder;
        const std::size_t before = live;
        peak = before;
        const Accel accel = Accel::build(mesh.input(), settings);
        const double resident = static_cast<double>(live - before) / triangles,
                     atPeak = static_cast<double>(peak - before) / triangles;
        fmt::print("{}: {:.0f} bytes per triangle, {:.0f} at the peak\n", name, resident, atPeak);
        EXPECT_LE(resident, 80.0) << name;
        EXPECT_LE(atPeak, 250.0) << name;
        EXPECT_NEAR(static_cast<double>(accel.bytes()) / triangles, resident, 2.0) << name;
    }
}

}  // namespace
}  // namespace rayscope::test
