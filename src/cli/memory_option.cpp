#include "cli/memory_option.h"

#include <rayscope/memory.h>

#include <algorithm>
#include <thread>

#include "base/byte_size.h"
#include "base/memory_budget.h"
#include "base/printable_text.h"
#include "cli/command_line.h"

namespace rayscope::cli {

namespace {

/// The number of threads that the options ask for, or one per core.
int threadsOf(const OptionList& list) {
    int threads = 0;
    for (const Option& option : list.options())
        if (const auto* const* target = std::get_if<int*>(&option.target);
            target && option.mainName() == "--threads")
            threads = **target;
    return std::max(threads, static_cast<int>(std::thread::hardware_concurrency()));
}

std::uint64_t parseLimit(const std::string& text) {
    if (text == "none") return kNoMemoryLimit;
    if (const auto bytes = base::parseByteSize(text)) return *bytes;
    throw UsageError(
        "--memory-limit",
        "expected none or a size with a unit, such as 500M, 8G or 1.5GB, got " + base::quoted(text));
}

}  // namespace

void MemoryOption::addTo(OptionList& list) {
    list.add("--memory-limit", &limit_,
             "End with a message rather than use more memory than this, such as 500M or 8G; none: no limit; "
             "by "
             "default 80 % of the memory of the machine or control group")
        .form("SIZE");
}

void MemoryOption::apply(const OptionList& list, bool opensWindow) const {
    if (!limit_.empty()) setMemoryLimit(parseLimit(limit_));
    // Drivers of graphics cards reserve memory as they like and end the program if they get none.
    constexpr std::uint64_t kStack = std::uint64_t{9} << 20;
    if (!opensWindow) base::enforceMemoryLimit(kStack * static_cast<std::uint64_t>(threadsOf(list) + 8));
}

}  // namespace rayscope::cli
