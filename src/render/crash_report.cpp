#include "render/crash_report.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>

#include "base/temporary_files.h"

namespace rayscope::render {

namespace {

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// More threads than this share slots; then only the latest sample of a slot is reported.
constexpr std::size_t kSlots = 256;
std::array<CurrentSample, kSlots> slots;
std::atomic<std::size_t> nextSlot{0};

/// Two buffers: one is valid while the other is written, because a signal handler may not take a lock.
struct ContextBuffer {
    char scene[4096], settings[4096], beforeX[4096], beforeY[64], beforeIndex[64];
};
ContextBuffer buffers[2];
std::atomic<const ContextBuffer*> valid{nullptr};

template <std::size_t N>
void copy(char (&to)[N], const std::string& from) {
    const std::size_t size = std::min(from.size(), N - 1);
    std::memcpy(to, from.data(), size);
    to[size] = '\0';
}

// A signal handler may only call async-signal-safe functions such as write(): no allocation, no lock.
void print(const char* text) {
    [[maybe_unused]] const auto n = write(STDERR_FILENO, text, std::strlen(text));
}

void print(int number) {
    char digits[16];
    char* at = digits + sizeof digits - 1;
    *at = '\0';
    for (auto rest = static_cast<unsigned>(number); rest != 0 || *at == '\0'; rest /= 10)
        *--at = static_cast<char>('0' + rest % 10);
    print(at);
}

void printCommand(const ContextBuffer& context, const SampleId& sample) {
    print("  ");
    print(context.beforeX);
    print(sample.x);
    print(context.beforeY);
    print(sample.y);
    print(context.beforeIndex);
    print(sample.index);
    print("\n");
}

const char* nameOf(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "segmentation fault";
        case SIGBUS:
            return "bus error";
        case SIGFPE:
            return "arithmetic exception";
        case SIGILL:
            return "illegal instruction";
        default:
            return "aborted, for example by a failed assertion";
    }
}

thread_local CurrentSample* own = nullptr;

/// The stack of signal handlers of a thread, for the case that its own has overflowed.
class AlternateStack {
  public:
    AlternateStack() {
        stack_t current{};
        sigaltstack(nullptr, &current);
        if (!(current.ss_flags & SS_DISABLE)) return;  // installed by a sanitizer
        memory_ = std::make_unique<char[]>(kBytes);
        stack_t alternate{};
        alternate.ss_sp = memory_.get();
        alternate.ss_size = kBytes;
        sigaltstack(&alternate, nullptr);
    }
    ~AlternateStack() {
        if (!memory_) return;
        stack_t none{};
        none.ss_flags = SS_DISABLE;
        sigaltstack(&none, nullptr);
    }
    AlternateStack(const AlternateStack&) = delete;
    AlternateStack& operator=(const AlternateStack&) = delete;

    /// Kept by a key of the thread library: to register the destructor of a thread_local object, the C
    /// library allocates memory, and it ends the program if there is none.
    static void ofThisThread() {
        static const pthread_key_t key = keyWithDestructor();
        if (pthread_getspecific(key) != nullptr) return;
        auto stack = std::make_unique<AlternateStack>();
        if (pthread_setspecific(key, stack.get()) == 0) static_cast<void>(stack.release());
    }

  private:
    static pthread_key_t keyWithDestructor() {
        pthread_key_t key = 0;
        const auto destroy = [](void* stack) { delete static_cast<AlternateStack*>(stack); };
        if (pthread_key_create(&key, destroy) != 0) throw std::bad_alloc();
        return key;
    }

    static constexpr std::size_t kBytes = std::size_t{64} << 10;
    std::unique_ptr<char[]> memory_;
};

void printSamplesInFlight(const ContextBuffer& context) {
    const bool isOwn = own != nullptr && own->isSet();
    if (isOwn) {
        print("this sample was being traced; repeat it with\n");
        printCommand(context, own->get());
    }
    bool isFirst = true;
    for (const CurrentSample& slot : slots) {
        if (!slot.isSet() || (isOwn && &slot == own)) continue;
        if (isFirst) print("other threads were tracing\n");
        isFirst = false;
        printCommand(context, slot.get());
    }
    if (isFirst && !isOwn) print("no sample was being traced\n");
}

void report(int signal) {
    print("\nrayscope crashed: signal ");
    print(signal);
    print(" (");
    print(nameOf(signal));
    print(")\n");
    if (const ContextBuffer* context = valid.load()) {
        print("scene: ");
        print(context->scene);
        print("\nsettings: ");
        print(context->settings);
        print("\n");
        printSamplesInFlight(*context);
    }
    base::removeTemporaryFiles();
    // The default action ends the program with the status of the signal.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

void setCrashContext(const CrashContext& context) {
    static std::mutex lock;
    const std::scoped_lock guard(lock);
    ContextBuffer& unused = valid.load() == &buffers[0] ? buffers[1] : buffers[0];
    copy(unused.scene, context.scene);
    copy(unused.settings, context.settings);
    copy(unused.beforeX, context.beforeX);
    copy(unused.beforeY, context.beforeY);
    copy(unused.beforeIndex, context.beforeIndex);
    valid = &unused;
}

CurrentSample& CurrentSample::ofThisThread() {
    if (own == nullptr) {
        own = &slots[nextSlot++ % kSlots];
        AlternateStack::ofThisThread();
    }
    return *own;
}

void installCrashReport() {
    AlternateStack::ofThisThread();
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

}  // namespace rayscope::render
