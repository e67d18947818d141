// Threads: oneTBB, or std::thread if oneTBB is absent or a race detector must see every lock.
// Does not promise an order: the results of the bodies must not depend on it.
#pragma once

#include <cstddef>
#include <functional>

namespace gw {

/// The number of threads that this computer runs at a time.
int hardware_threads();

/// Calls body(i, worker) once for each i in 0 .. count - 1 on up to `threads` threads (0: all);
/// `worker` in 0 .. threads - 1 names the calling thread. Returns when all calls have returned and
/// rethrows the first exception. If the system refuses threads, fewer are used; a
/// child of fork() after the first call uses the calling one alone.
/// Every body runs with nearest-even rounding and gradual underflow.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& body);

/// For a process that ends while other threads go on: waits for their calls of parallel_for, and has
/// all later ones use the calling thread alone. oneTBB's own objects may then go.
void end_parallel_loops();

/// Sets nearest-even rounding and gradual underflow; its destructor restores the caller's modes.
class FloatEnvironment {
public:
    FloatEnvironment();
    ~FloatEnvironment();
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
    bool changed_;
    alignas(16) unsigned char saved_[64];
};

}  // namespace gw
