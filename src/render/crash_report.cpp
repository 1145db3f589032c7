#include "render/crash_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>

#include "base/shell_quote.h"

namespace rayscope::render {

namespace {

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Threads beyond these share slots, so that of some only the latest sample is known.
constexpr std::size_t kSlots = 256;
std::array<CurrentSample, kSlots> slots;
std::atomic<std::size_t> nextSlot{0};

/// Two texts, of which one is valid while the other is written: a handler of signals may not wait.
struct Description {
    char scene[4096], settings[4096], command[4096];
};
Description descriptions[2];
std::atomic<const Description*> valid{nullptr};

template <std::size_t N>
void copy(char (&to)[N], const std::string& from) {
    const std::size_t size = std::min(from.size(), N - 1);
    std::memcpy(to, from.data(), size);
    to[size] = '\0';
}

// In a handler of signals only write() and the like may be called: nothing that allocates or locks.
void say(const char* words) {
    [[maybe_unused]] const auto n = write(STDERR_FILENO, words, std::strlen(words));
}

void say(int number) {
    char digits[16];
    char* at = digits + sizeof digits - 1;
    *at = '\0';
    for (auto rest = static_cast<unsigned>(number); rest != 0 || *at == '\0'; rest /= 10)
        *--at = static_cast<char>('0' + rest % 10);
    say(at);
}

void sayCommand(const Description& work, const SampleId& name) {
    say("  ");
    say(work.command);
    say(" --pixel ");
    say(name.x);
    say(",");
    say(name.y);
    say(" --sample ");
    say(name.index);
    say("\n");
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
            return "aborted, as by an assertion that failed";
    }
}

thread_local CurrentSample* own = nullptr;

/// Where the handler runs in a thread whose own stack is used up.
class AlternateStack {
  public:
    AlternateStack() {
        stack_t present{};
        sigaltstack(nullptr, &present);
        if (!(present.ss_flags & SS_DISABLE)) return;  // that of a sanitizer
        memory_ = std::make_unique<char[]>(kBytes);
        stack_t wanted{};
        wanted.ss_sp = memory_.get();
        wanted.ss_size = kBytes;
        sigaltstack(&wanted, nullptr);
    }
    ~AlternateStack() {
        if (!memory_) return;
        stack_t none{};
        none.ss_flags = SS_DISABLE;
        sigaltstack(&none, nullptr);
    }
    AlternateStack(const AlternateStack&) = delete;
    AlternateStack& operator=(const AlternateStack&) = delete;

    static void ofThisThread() { static thread_local AlternateStack stack; }

  private:
    static constexpr std::size_t kBytes = std::size_t{64} << 10;
    std::unique_ptr<char[]> memory_;
};

void report(int signal) {
    say("\nrayscope crashed: signal ");
    say(signal);
    say(" (");
    say(nameOf(signal));
    say(")\n");
    if (const Description* work = valid.load()) {
        say("scene: ");
        say(work->scene);
        say("\nsettings: ");
        say(work->settings);
        say("\n");
        const bool isOwn = own != nullptr && own->isBusy();
        if (isOwn) {
            say("this sample was being traced; repeat it with\n");
            sayCommand(*work, own->name());
        }
        bool isFirst = true;
        for (const CurrentSample& slot : slots) {
            if (!slot.isBusy() || (isOwn && &slot == own)) continue;
            if (isFirst) say("other threads were tracing\n");
            isFirst = false;
            sayCommand(*work, slot.name());
        }
        if (isFirst && !isOwn) say("no sample was being traced\n");
    }
    // The default action ends the program as if nobody had listened.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

std::string vectorText(const glm::vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

/// Those that differ from the defaults, or that the scene sets otherwise.
std::vector<std::string> assignmentsOf(const RenderRequest& request) {
    Settings ofScene;
    for (const SettingAssignment& assignment : request.scene->settings)
        assign(ofScene, assignment.key, assignment.value);
    std::vector<std::string> words;
    for (const std::string_view key : settingKeys()) {
        const std::string value = textOf(request.settings, key);
        if (value != textOf(ofScene, key)) words.push_back(fmt::format("{}={}", key, value));
    }
    return words;
}

}  // namespace

std::string probeCommandOf(const RenderRequest& request) {
    const CameraDescription& camera = request.camera;
    std::string words = fmt::format("rayscope probe {} --size {}x{}", base::shellQuote(request.scene->path),
                                    request.width, request.height);
    for (const CameraDescription& known : request.scene->cameras)
        if (known.name == camera.name && &known != request.scene->cameras.data())
            words += " --camera " + base::shellQuote(camera.name);
    words += fmt::format(" --look-from {} --look-at {} --up {} --fov {}", vectorText(camera.lookFrom),
                         vectorText(camera.lookAt), vectorText(camera.up), camera.fov);
    if (request.seed != 0) words += fmt::format(" --seed {}", request.seed);
    for (const std::string& assignment : assignmentsOf(request))
        words += " --set " + base::shellQuote(assignment);
    return words;
}

void describeForCrashReport(const RenderRequest& request) {
    static std::mutex lock;
    const std::scoped_lock guard(lock);
    Description& unused = valid.load() == &descriptions[0] ? descriptions[1] : descriptions[0];
    copy(unused.scene, fmt::format("{}, {} x {} pixels, seed {}", request.scene->path, request.width,
                                   request.height, request.seed));
    const std::vector<std::string> assignments = assignmentsOf(request);
    copy(unused.settings, assignments.empty() ? "as the scene sets them, or defaults"
                                              : fmt::format("{}", fmt::join(assignments, " ")));
    copy(unused.command, probeCommandOf(request));
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
