#include "faults/fault_points.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/mman.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

namespace rayscope::test {

namespace {

struct Shared {
    std::atomic<std::uint64_t> calls;
};

std::atomic<bool> isArmed{false};
FaultKind armedKind = FaultKind::Allocation;
std::uint64_t failingPoint = 0;
bool failsAfter = false;

Shared& shared() {
    static auto* const memory = static_cast<Shared*>(
        ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    return *memory;
}

bool failsNow(FaultKind kind) {
    if (!isArmed.load(std::memory_order_acquire) || armedKind != kind) return false;
    const std::uint64_t number = shared().calls.fetch_add(1) + 1;
    return failingPoint != 0 && (number == failingPoint || (failsAfter && number > failingPoint));
}

}  // namespace

void FaultPoints::arm(FaultKind kind, std::uint64_t point, bool andAllAfter) {
    shared().calls = 0;
    armedKind = kind;
    failingPoint = point;
    failsAfter = andAllAfter;
    isArmed.store(true, std::memory_order_release);
}

void FaultPoints::disarm() { isArmed = false; }

std::uint64_t FaultPoints::count() { return shared().calls; }

}  // namespace rayscope::test

using rayscope::test::failsNow;
using rayscope::test::FaultKind;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)

// The sanitizers have a malloc() of their own; only allocations of C++ fail.
namespace {

void* allocateOrNull(std::size_t size, std::size_t alignment) {
    if (failsNow(FaultKind::Allocation)) return nullptr;
    return alignment > alignof(std::max_align_t)
               ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
               : std::malloc(size);
}

void* allocate(std::size_t size, std::size_t alignment) {
    void* const memory = allocateOrNull(size, alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

// GCC does not see that allocate() calls malloc().
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new[](std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocateOrNull(size, 1); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocateOrNull(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocateOrNull(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocateOrNull(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#else

// The functions of the C library under its own names for programs that replace them.
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

namespace {
bool lacksMemory() {
    if (!failsNow(FaultKind::Allocation)) return false;
    errno = ENOMEM;
    return true;
}
}  // namespace

void* malloc(std::size_t size) { return lacksMemory() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) {
    return lacksMemory() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
    return lacksMemory() ? nullptr : __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
    return lacksMemory() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return lacksMemory() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    *memory = lacksMemory() ? nullptr : __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}

}  // extern "C"

#endif

#if !defined(__SANITIZE_THREAD__)

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                              void* argument) {
    if (failsNow(FaultKind::Thread)) return EAGAIN;
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
    return create(thread, attributes, start, argument);
}

#endif
