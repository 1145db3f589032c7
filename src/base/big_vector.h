#pragma once
// Vectors in huge pages, for large arrays.
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace rayscope::base {

/// Allocates memory aligned to a cache line, from two megabytes on in huge pages where the system has them:
/// fewer page faults, and fewer TLB misses than with 4 KiB pages. Throws
/// std::bad_alloc, and OutOfMemory beyond the memory limit.
void* allocateBig(std::size_t bytes);
void freeBig(void* memory, std::size_t bytes) noexcept;

/// The allocator of BigVector. Elements of trivial types are not zeroed, so that the threads that write them
/// first also fault in their pages.
template <class T>
struct BigAllocator {
    using value_type = T;
    using is_always_equal = std::true_type;

    BigAllocator() = default;
    template <class Other>
    BigAllocator(const BigAllocator<Other>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateBig(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) noexcept { freeBig(memory, count * sizeof(T)); }

    template <class Element>
    void construct(Element* element) noexcept(std::is_nothrow_default_constructible_v<Element>) {
        ::new (static_cast<void*>(element)) Element;
    }
    template <class Element, class... Arguments>
    void construct(Element* element, Arguments&&... arguments) {
        ::new (static_cast<void*>(element)) Element(std::forward<Arguments>(arguments)...);
    }

    friend bool operator==(const BigAllocator&, const BigAllocator&) { return true; }
};

/// A vector in huge pages; resize() leaves new elements of trivial types uninitialised.
template <class T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace rayscope::base
