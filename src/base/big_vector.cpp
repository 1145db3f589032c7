#include "base/big_vector.h"

#include <algorithm>

#include "base/memory_budget.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rayscope::base {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;
constexpr std::size_t kCacheLine = 64;

std::align_val_t alignmentFor(std::size_t bytes) {
    return std::align_val_t{bytes >= kHugePage - kHugePage / 8 ? kHugePage : kCacheLine};
}

}  // namespace

void* allocateBig(std::size_t bytes) {
    requireMemory(bytes, "a smaller scene", "a BVH or another large array");
    // A last huge page that is at least 7/8 used is allocated whole.
    const std::size_t inHugePages = (bytes + kHugePage / 8) / kHugePage * kHugePage;
    void* const memory = ::operator new(std::max(bytes, inHugePages), alignmentFor(bytes));
#ifdef MADV_HUGEPAGE
    // Only advice: failure leaves small pages.
    if (inHugePages > 0) madvise(memory, inHugePages, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeBig(void* memory, std::size_t bytes) noexcept { ::operator delete(memory, alignmentFor(bytes)); }

}  // namespace rayscope::base
