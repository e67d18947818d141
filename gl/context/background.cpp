#include "gl/context/background.h"

#include <unistd.h>
#include <set>
#include <utility>

namespace gw::gl {

/// Never destroyed: Backgrounds of static objects may go after everything else.
struct Background::Living {
    const pid_t process = getpid();  ///< a child has none of the threads
    std::mutex mutex;
    std::set<Background*> all;
    bool is_ending = false;

    bool is_child() const { return process != getpid(); }
    void finish_all() {
        const std::lock_guard lock(mutex);
        is_ending = true;
        if (is_child()) return;
        for (Background* background : all) background->finish();
    }
};

Background::Living& Background::living() {
    static Living& living = *new Living;
    // Made after the machine's own static objects, as a drawable's first frames run in its thread.
    static const struct AtExit {
        ~AtExit() { Background::living().finish_all(); }
    } at_exit;
    return living;
}

bool Background::is_available() {
    Living& living = Background::living();
    const std::lock_guard lock(living.mutex);
    return !living.is_ending && !living.is_child();
}

Background::Background() : thread_([this] { run(); }) {
    const std::lock_guard lock(living().mutex);
    living().all.insert(this);
}

Background::~Background() {
    {
        const std::lock_guard lock(living().mutex);
        living().all.erase(this);
    }
    if (living().is_child()) {
        thread_.detach();
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Background::start(std::function<void()> work) {
    {
        const std::lock_guard lock(mutex_);
        work_ = std::move(work);
    }
    changed_.notify_all();
}

void Background::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return work_ == nullptr; });
}

void Background::wait() {
    finish();
    if (const std::exception_ptr failure = std::exchange(failure_, nullptr))
        std::rethrow_exception(failure);
}

void Background::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return work_ != nullptr || ends_; });
        if (work_ == nullptr) return;
        lock.unlock();
        std::exception_ptr failure;
        try {
            work_();
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        failure_ = failure;
        work_ = nullptr;
        changed_.notify_all();
    }
}

}  // namespace gw::gl
