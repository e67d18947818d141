// Signals are for the program's own threads: a handler may call what must not wait for the thread that
// runs it, as exit().
#pragma once

#include <signal.h>

namespace gw {

/// While it lives, the calling thread takes no signals. Threads that it starts never do. Windows
/// sends none to a thread.
#ifdef _WIN32
class BlockedSignals {
public:
    BlockedSignals() {}
    ~BlockedSignals() {}
};
#else
class BlockedSignals {
public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

private:
    sigset_t before_;
};
#endif

}  // namespace gw
