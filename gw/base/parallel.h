// Threads, behind one file: oneTBB, or std::thread where that is absent or a race detector must see
// everything. Does not promise an order: what the bodies compute must not depend on it.
#pragma once

#include <cstddef>
#include <functional>

namespace gw {

/// Threads that are worth using here.
int hardware_threads();

/// Calls body(i, worker) once for each i in 0 .. count - 1 on up to `threads` threads (0: all);
/// `worker` in 0 .. threads - 1 names the calling thread. Returns when all are done; the first
/// exception is rethrown.
/// Every body runs with nearest-even rounding and gradual underflow.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& body);

/// Nearest-even rounding and gradual underflow while it lives; restores what was before.
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
