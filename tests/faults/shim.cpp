// Preloaded into the program: fails chosen system calls, and shifts its clocks.
//
// SHIM_COUNT=FILE       at the end writes to FILE how many calls could have failed
// SHIM_FAIL=K           the K-th call that creates, writes, names or moves a file fails as on a full disk
// SHIM_FAIL_ALL=1       and all later ones
// SHIM_NO_UNNAMED=1     files without a name are not supported
// SHIM_NO_LINK=1        files cannot get another name
// SHIM_JUMP=SECONDS     each reading of the time of day is off by a random time of up to so many seconds
// SHIM_STEP=SECONDS     after SHIM_STEP_AFTER readings the monotonic clock jumps by so many seconds
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#define NEXT(name) reinterpret_cast<decltype(&(name))>(dlsym(RTLD_NEXT, #name))

namespace {

long variable(const char* name) {
    const char* const text = getenv(name);
    return text ? atol(text) : 0;
}

std::atomic<long> calls;

int fails() {
    const long number = calls.fetch_add(1) + 1, wanted = variable("SHIM_FAIL");
    if (wanted == 0 || number < wanted || (number > wanted && !variable("SHIM_FAIL_ALL"))) return 0;
    errno = ENOSPC;
    return 1;
}

__attribute__((destructor)) void writeCount() {
    const char* const path = getenv("SHIM_COUNT");
    FILE* const file = path ? fopen(path, "w") : nullptr;
    if (!file) return;
    fprintf(file, "%ld\n", calls.load());
    fclose(file);
}

int isFile(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

int creates(int flags) { return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE; }

int isUnsupported(int flags) {
    if ((flags & O_TMPFILE) != O_TMPFILE || !variable("SHIM_NO_UNNAMED")) return 0;
    errno = EOPNOTSUPP;
    return 1;
}

std::atomic<long> readings;

long step() { return readings.load() > variable("SHIM_STEP_AFTER") ? variable("SHIM_STEP") : 0; }

long jump() {
    const long most = variable("SHIM_JUMP");
    static std::atomic<unsigned long> state{1};
    const unsigned long random = state.fetch_add(1) * 0x9e3779b97f4a7c15u >> 11;
    return most > 0 ? static_cast<long>(random % static_cast<unsigned long>(2 * most)) - most : 0;
}

}  // namespace

extern "C" {

#define OPEN(name)                                          \
    int name(const char* path, int flags, ...) {            \
        mode_t mode = 0;                                    \
        if (creates(flags)) {                               \
            va_list rest;                                   \
            va_start(rest, flags);                          \
            mode = va_arg(rest, mode_t);                    \
            va_end(rest);                                   \
            if (isUnsupported(flags) || fails()) return -1; \
        }                                                   \
        return NEXT(name)(path, flags, mode);               \
    }
OPEN(open)
OPEN(open64)

ssize_t write(int descriptor, const void* bytes, size_t count) {
    if (isFile(descriptor) && fails()) return -1;
    return NEXT(write)(descriptor, bytes, count);
}

ssize_t sendfile(int to, int from, off_t* offset, size_t count) noexcept {
    return fails() ? -1 : NEXT(sendfile)(to, from, offset, count);
}

int linkat(int oldFolder, const char* from, int newFolder, const char* to, int flags) noexcept {
    if (variable("SHIM_NO_LINK")) {
        errno = EPERM;
        return -1;
    }
    return fails() ? -1 : NEXT(linkat)(oldFolder, from, newFolder, to, flags);
}

int rename(const char* from, const char* to) noexcept { return fails() ? -1 : NEXT(rename)(from, to); }

int mkdir(const char* path, mode_t mode) noexcept { return fails() ? -1 : NEXT(mkdir)(path, mode); }

int clock_gettime(clockid_t clock, timespec* time) noexcept {
    const int result = NEXT(clock_gettime)(clock, time);
    if (clock == CLOCK_REALTIME) time->tv_sec += jump();
    if (clock == CLOCK_MONOTONIC) {
        readings.fetch_add(1);
        time->tv_sec += step();
    }
    return result;
}

int gettimeofday(timeval* __restrict time, void* __restrict zone) noexcept {
    const int result = NEXT(gettimeofday)(time, zone);
    time->tv_sec += jump();
    return result;
}

time_t time(time_t* result) noexcept {
    const time_t now = NEXT(time)(nullptr) + jump();
    if (result) *result = now;
    return now;
}

// The kernel does not know of the step.
int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* until) {
    timespec real = *until;
    if (clock == CLOCK_MONOTONIC) real.tv_sec -= step();
    return NEXT(pthread_cond_clockwait)(condition, mutex, clock, &real);
}

}  // extern "C"
