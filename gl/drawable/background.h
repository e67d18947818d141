// A thread that works for another one, a piece at a time, and what both do when the program ends. Does
// not know the work.
#pragma once

#include <functional>
#include <memory>

namespace gw::gl {

/// Before the process ends, all Backgrounds finish their work. A child process (fork) has none of
/// the threads and leaves their work undone.
class Background {
public:
    /// Throws std::system_error if the system gives no thread.
    Background();
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Precondition: nothing is being worked on. Once the program is ending, the caller works.
    void start(std::function<void()> work);
    /// Returns when all work is done. Rethrows its errors.
    void wait();

    /// False once the program is ending, in a child process, and on Windows, where its thread would
    /// be gone before its work is done.
    static bool is_available();

    /// A use of Xlib, which ends with the program: false if the program is ending. Other threads may
    /// go on after the exit handlers; the process ends 2 seconds later at most while they use it.
    class Use {
    public:
        Use();
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;
        explicit operator bool() const { return allowed_; }

    private:
        bool allowed_ = false;
    };

private:
    struct AtExit;
    struct Living;
    struct Worker;
    static Living& living();

    std::unique_ptr<Worker> worker_;
};

/// Windows ends a program's other threads before its libraries end: they may be in the middle of
/// anything, and nobody can wait for them. Elsewhere they still run.
#ifdef _WIN32
inline constexpr bool other_threads_are_gone = true;
#else
inline constexpr bool other_threads_are_gone = false;
#endif

}  // namespace gw::gl
