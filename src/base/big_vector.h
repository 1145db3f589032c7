#pragma once
// Memory for arrays that may become very large.
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace rayscope::base {

/// Memory for `bytes` bytes, aligned for anything up to a cache line. From two megabytes on it lies in huge
/// pages where the system has them: of pages of 4 KiB each has to be faulted in by itself, and the processor
/// remembers the addresses of a few megabytes only. Throws std::bad_alloc.
void* allocateBig(std::size_t bytes);
void freeBig(void* memory, std::size_t bytes) noexcept;

/// For BigVector. Elements without a constructor of their own are not filled with zeros: whoever writes them
/// first, often one of several threads, faults their pages in.
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

/// A vector in huge pages, whose resize() leaves new elements as they are in memory.
template <class T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace rayscope::base
