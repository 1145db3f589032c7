#pragma once
// Checks before large allocations, and what to say when memory runs out. docs/memory.md describes the limits.
#include <fmt/format.h>
#include <rayscope/memory.h>

#include <cstdint>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

namespace rayscope::base {

/// Smaller allocations are not worth a check, which costs a few microseconds.
inline constexpr std::uint64_t kUncheckedBytes = std::uint64_t{1} << 20;

/// Throws OutOfMemory: `what` needs `bytes`, which are more than are available. `advice` names what helps,
/// such as "a smaller --size".
[[noreturn]] void throwTooLarge(std::uint64_t bytes, std::string_view what, std::string_view advice);

/// Throws OutOfMemory unless `bytes` more can be allocated. The message says what needs them, such as "an
/// image of {} x {} pixels", and names `advice` as what helps.
template <class... Values>
void requireMemory(std::uint64_t bytes, std::string_view advice, fmt::format_string<Values...> what,
                   Values&&... values) {
    if (bytes >= kUncheckedBytes && bytes > availableMemory())
        throwTooLarge(bytes, fmt::format(what, std::forward<Values>(values)...), advice);
}

/// Throws OutOfMemory, with the name of the work, if all of the available memory is in use: for work that
/// grows in many small steps.
void requireSomeMemory(std::string_view work, std::string_view advice);

/// Throws OutOfMemory unless the vector has room for one more element, or memory to double its capacity.
template <class Vector>
void requireRoom(const Vector& vector, std::string_view what, std::string_view advice) {
    if (vector.size() == vector.capacity())
        requireMemory(2 * vector.capacity() * sizeof(typename Vector::value_type), advice, "{}", what);
}

/// Throws OutOfMemory: "out of memory while WORK; use ADVICE …". Allocates nothing.
[[noreturn]] void throwOutOfMemoryWhile(std::string_view work, std::string_view advice);

/// Returns work(). If it runs out of memory without a message, throws OutOfMemory with one that names it.
template <class Work>
decltype(auto) namingLackOfMemory(std::string_view name, std::string_view advice, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const OutOfMemory&) {
        throw;
    } catch (const std::bad_alloc&) {
        throwOutOfMemoryWhile(name, advice);
    }
}

/// What to tell the user: the message of an OutOfMemory, and one without a name for other exceptions.
const char* messageOf(const std::bad_alloc& error) noexcept;

/// Whether an exception of another library reports a std::bad_alloc that it caught.
bool reportsLackOfMemory(const std::exception& error);

/// Lets the system refuse memory beyond memoryLimit() and `allowance` bytes, for stacks of threads and other
/// memory that is reserved but not used, so that allocations without a check end, too. To be called again
/// after setMemoryLimit().
void enforceMemoryLimit(std::uint64_t allowance);

}  // namespace rayscope::base
