// A thread that works for another one, a piece at a time. Does not know the work.
#pragma once

#include <functional>
#include <memory>

namespace gw::gl {

/// Before the process ends, all Backgrounds finish their work. In a child process
/// (fork), which has none of the threads, what was not done is left.
class Background {
public:
    /// Throws std::system_error if the system gives no thread.
    Background();
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Precondition: nothing is being worked on. Once the program is ending, the caller works.
    void start(std::function<void()> work);
    /// Returns when all work is done. Rethrows what it threw.
    void wait();

    /// False once the program is ending, and in a child process.
    static bool is_available();
    /// After the program's exit handlers. Other threads may go on meanwhile.
    static bool is_program_ending();

private:
    struct AtExit;
    struct Living;
    struct Worker;
    static Living& living();

    std::unique_ptr<Worker> worker_;
};

}  // namespace gw::gl
