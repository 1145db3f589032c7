#include "base/memory_budget.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <span>

#include "base/byte_size.h"
#include "base/system_memory.h"

namespace rayscope {

namespace {

constexpr double kDefaultShare = 0.8;

/// What setMemoryLimit() was called with; 0: never.
std::atomic<std::uint64_t> chosenLimit{0};
/// The limit of the data segment that enforceMemoryLimit() has set; 0: none.
std::atomic<std::uint64_t> enforcedLimit{0};

/// One bound on the memory of the process.
struct Bound {
    std::uint64_t limit, used;
    std::string_view name;    ///< where it comes from
    std::string_view remedy;  ///< how it is raised
    std::uint64_t left() const { return limit - std::min(used, limit); }
};

struct DefaultLimit {
    std::uint64_t bytes;
    std::string_view name;
};

/// Looked up once: the limits of a running process hardly change.
const DefaultLimit& defaultLimit() {
    static const DefaultLimit limit = [] {
        const std::uint64_t machine = base::physicalMemory(), group = base::controlGroupMemory();
        const std::uint64_t least = std::min(machine, group);
        if (least == kNoMemoryLimit) return DefaultLimit{kNoMemoryLimit, ""};
        return DefaultLimit{
            static_cast<std::uint64_t>(kDefaultShare * static_cast<double>(least)),
            group < machine ? "80 % of its control group" : "80 % of the memory of this machine"};
    }();
    return limit;
}

std::uint64_t softLimit(__rlimit_resource resource) {
    rlimit limit{};
    return ::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ? kNoMemoryLimit
                                                                                 : limit.rlim_cur;
}

/// The bound that leaves the least.
Bound tightestBound() {
    const base::MemoryUse use = base::memoryUse();
    const std::uint64_t data = softLimit(RLIMIT_DATA), chosen = chosenLimit;
    const std::array<Bound, 3> bounds{
        Bound{memoryLimit(), std::max(use.resident, use.allocated),
              chosen != 0 ? "the memory limit" : defaultLimit().name, "a larger --memory-limit"},
        {softLimit(RLIMIT_AS), use.addressSpace, "the address space, ulimit -v", "a larger ulimit -v"},
        {data == enforcedLimit ? kNoMemoryLimit : data, use.dataSegment, "the data segment, ulimit -d",
         "a larger ulimit -d"}};
    return *std::min_element(bounds.begin(), bounds.end(),
                             [](const Bound& a, const Bound& b) { return a.left() < b.left(); });
}

}  // namespace

OutOfMemory::OutOfMemory(std::string_view message) noexcept {
    const std::size_t size = std::min(message.size(), sizeof text_ - 1);
    std::memcpy(text_, message.data(), size);
    text_[size] = 0;
}

void setMemoryLimit(std::uint64_t bytes) { chosenLimit = std::max<std::uint64_t>(bytes, 1); }

std::uint64_t memoryLimit() {
    const std::uint64_t chosen = chosenLimit;
    return chosen != 0 ? chosen : defaultLimit().bytes;
}

std::uint64_t availableMemory() { return tightestBound().left(); }

namespace base {

void throwTooLarge(std::uint64_t bytes, std::string_view what, std::string_view advice) {
    const Bound bound = tightestBound();
    throw OutOfMemory(fmt::format("out of memory: {} needs {}, but only {} of {} ({}) are left; use {} or {}",
                                  what, byteSizeText(bytes), byteSizeText(bound.left()),
                                  byteSizeText(bound.limit), bound.name, advice, bound.remedy));
}

void requireSomeMemory(std::string_view work, std::string_view advice) {
    const Bound bound = tightestBound();
    if (bound.left() > 0) return;
    throw OutOfMemory(fmt::format("out of memory while {}: all of {} ({}) are in use; use {} or {}", work,
                                  byteSizeText(bound.limit), bound.name, advice, bound.remedy));
}

void throwOutOfMemoryWhile(std::string_view work, std::string_view advice) {
    char text[480];
    const auto end = fmt::format_to_n(text, sizeof text,
                                      "out of memory while {}; use {}, or end other programs", work, advice);
    throw OutOfMemory({text, std::min(end.size, sizeof text)});
}

const char* messageOf(const std::bad_alloc& error) noexcept {
    if (const auto* named = dynamic_cast<const OutOfMemory*>(&error)) return named->what();
    return "out of memory; use a smaller --size or a smaller scene, or end other programs";
}

bool reportsLackOfMemory(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
           std::strstr(error.what(), "bad_alloc") != nullptr;
}

void enforceMemoryLimit(std::uint64_t allowance) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    static const rlim_t original = limit.rlim_cur;
    const MemoryUse use = memoryUse();
    const std::uint64_t reserved = use.dataSegment - std::min(use.dataSegment, use.resident);
    const std::uint64_t most = memoryLimit();
    const bool isLimited = most < kNoMemoryLimit - allowance - reserved;
    limit.rlim_cur = isLimited ? std::min<rlim_t>(original, most + allowance + reserved) : original;
    if (::setrlimit(RLIMIT_DATA, &limit) == 0)
        enforcedLimit = limit.rlim_cur == original ? 0 : limit.rlim_cur;
}

}  // namespace base

}  // namespace rayscope
