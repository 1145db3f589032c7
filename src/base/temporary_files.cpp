#include "base/temporary_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace rayscope::base {

namespace {

/// A handler may interrupt any instruction: it reads a path only while the slot is Set.
enum SlotState : int { Free, Busy, Set };
struct Slot {
    std::atomic<int> state{Free};
    char path[4096];
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<Slot, 32> slots;

int occupySlot(const std::string& path) {
    if (path.size() >= sizeof Slot::path) return -1;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        int expected = Free;
        if (!slots[i].state.compare_exchange_strong(expected, Busy)) continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].state = Set;
        return static_cast<int>(i);
    }
    return -1;
}

}  // namespace

TemporaryName::TemporaryName(const std::string& path) : slot_(occupySlot(path)) {}
TemporaryName::~TemporaryName() {
    if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state = Free;
}

void removeTemporaryFiles() noexcept {
    for (const Slot& slot : slots)
        if (slot.state == Set) ::unlink(slot.path);
}

}  // namespace rayscope::base
