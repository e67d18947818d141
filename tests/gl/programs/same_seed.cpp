// Loaded before xscreensaver's programs, whose seed is made of the time and the process: both are the
// same in every run, so that what they draw is the same.
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

/// Whole seconds since the first call.
extern "C" int gettimeofday(timeval* __restrict now, void* __restrict) noexcept {
    timespec monotonic{};
    clock_gettime(CLOCK_MONOTONIC, &monotonic);
    static const time_t first = monotonic.tv_sec;
    *now = {.tv_sec = 700'000'000 + monotonic.tv_sec - first, .tv_usec = 0};
    return 0;
}

extern "C" pid_t getpid() noexcept { return 1991; }
