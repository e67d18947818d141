// A thread that works for another one, a piece at a time. Does not know the work.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace gw::gl {

/// Before the program's static objects go, all Backgrounds finish their work.
class Background {
public:
    /// Throws std::system_error if the system gives no thread.
    Background();
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Precondition: nothing is being worked on.
    void start(std::function<void()> work);
    /// Returns when all work is done. Rethrows what it threw.
    void wait();

    /// False once the program is ending.
    static bool is_available();

private:
    struct Living;
    static Living& living();
    void run();
    void finish();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> work_;  ///< null: nothing to do
    std::exception_ptr failure_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace gw::gl
