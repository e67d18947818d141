#include "apps/command/progress.h"

#include "apps/command/terminal.h"

#include <chrono>
#include <system_error>

namespace gw::apps {

Progress::Progress(std::string what, bool quiet) : what_(std::move(what)) {
    if (quiet || !error_is_terminal()) return;
    try {
        thread_ = std::thread([this] { show(); });
    } catch (const std::system_error&) {
        // The system refuses another thread: the work goes on without progress.
    }
}

Progress::~Progress() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void Progress::at(std::string what) {
    const std::lock_guard lock(mutex_);
    what_ = std::move(what);
}

void Progress::show() {
    std::unique_lock lock(mutex_);
    for (int seconds = 1;; ++seconds) {
        if (ended_.wait_for(lock, std::chrono::seconds(1), [this] { return end_; })) {
            if (seconds > 1) clear_error_line();
            return;
        }
        clear_error_line();
        print_error(as_one_line("gw: " + what_ + ", " + std::to_string(seconds) + " s"));
    }
}

}  // namespace gw::apps
