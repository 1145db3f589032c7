#include "base/system_memory.h"

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include <rayscope/diagnostics.h>
#include <rayscope/memory.h>
#include "base/parse_number.h"
#include "base/read_file.h"

namespace rayscope::base {

namespace {

namespace fs = std::filesystem;

/// "" if there is no such file.
std::string contentOf(const fs::path& file) {
    try {
        return readFile(file.string());
    } catch (const InputError&) {
        return {};
    }
}

/// The number that the file holds; kNoMemoryLimit if there is no such file or no number, such as "max".
std::uint64_t limitIn(const fs::path& file) {
    const std::string content = contentOf(file);
    const std::string_view word = std::string_view(content).substr(0, content.find('\n'));
    return parseInteger<std::uint64_t>(word).value_or(kNoMemoryLimit);
}

/// The smallest of the limits of a group and of those above it. In a container the path may be that outside,
/// and the folder of the group is the root of the hierarchy.
std::uint64_t smallestLimit(const fs::path& hierarchy, std::string_view group, const char* file) {
    std::uint64_t least = limitIn(hierarchy / file);
    for (fs::path path = fs::path(group).relative_path(); !path.empty(); path = path.parent_path())
        least = std::min(least, limitIn(hierarchy / path / file));
    return least;
}

bool containsWord(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(','), list.size());
        if (list.substr(0, end) == word) return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

/// The numbers of pages in /proc/self/statm, read without allocating.
std::array<std::uint64_t, 6> pagesOfProcess() {
    std::array<std::uint64_t, 6> pages{};
    char text[256];
    const int descriptor = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return pages;
    const ssize_t size = ::read(descriptor, text, sizeof text);
    ::close(descriptor);
    const char* at = text;
    const char* const end = text + std::max<ssize_t>(size, 0);
    for (std::uint64_t& count : pages) {
        at = std::from_chars(at, end, count).ptr;
        if (at < end) ++at;  // a blank
    }
    return pages;
}

std::uint64_t allocatedBytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

std::uint64_t pageSize() { return static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)); }

}  // namespace

std::uint64_t physicalMemory() {
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    return pages > 0 ? static_cast<std::uint64_t>(pages) * pageSize() : kNoMemoryLimit;
}

std::uint64_t controlGroupMemory(const fs::path& root) {
    std::uint64_t least = kNoMemoryLimit;
    const std::string groups = contentOf(root / "proc/self/cgroup");
    // "0::/group" of version 2, "5:memory:/group" of version 1.
    for (std::string_view rest = groups; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        const std::size_t first = line.find(':');
        const std::size_t second = first == line.npos ? first : line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string_view controllers = line.substr(first + 1, second - first - 1);
        const std::string_view group = line.substr(second + 1);
        if (controllers.empty())
            least = std::min(least, smallestLimit(root / "sys/fs/cgroup", group, "memory.max"));
        else if (containsWord(controllers, "memory"))
            least =
                std::min(least, smallestLimit(root / "sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
    }
    return least;
}

MemoryUse memoryUse() {
    const std::array<std::uint64_t, 6> pages = pagesOfProcess();
    const std::uint64_t size = pageSize();
    return {pages[1] * size, allocatedBytes(), pages[0] * size, pages[5] * size};
}

}  // namespace rayscope::base
