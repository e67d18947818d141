#include "gl/drawable/background.h"

#include "gw/base/blocked_signals.h"
#include "gw/base/parallel.h"

#include <unistd.h>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace gw::gl {

struct Background::Worker {
    Worker() : thread([this] { run(); }) {}
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void start(std::function<void()> new_work);
    void finish();
    void run();

    std::mutex mutex;
    std::condition_variable changed;
    std::function<void()> work;  ///< null: nothing to do
    std::exception_ptr failure;
    bool ends = false;
    std::thread thread;
};

Background::Worker::~Worker() {
    {
        const std::lock_guard lock(mutex);
        ends = true;
    }
    changed.notify_all();
    thread.join();
}

void Background::Worker::start(std::function<void()> new_work) {
    {
        const std::lock_guard lock(mutex);
        work = std::move(new_work);
    }
    changed.notify_all();
}

void Background::Worker::finish() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return work == nullptr; });
}

void Background::Worker::run() {
    std::unique_lock lock(mutex);
    while (true) {
        changed.wait(lock, [this] { return work != nullptr || ends; });
        if (work == nullptr) return;
        lock.unlock();
        std::exception_ptr failed;
        try {
            work();
        } catch (...) {
            failed = std::current_exception();
        }
        lock.lock();
        failure = failed;
        work = nullptr;
        changed.notify_all();
    }
}

/// Never destroyed: Backgrounds of static objects may go after everything else.
struct Background::Living {
    const pid_t process = getpid();
    std::mutex mutex;
    std::set<Worker*> all;
    std::atomic<bool> is_ending = false;  ///< changed under the mutex
    std::atomic<int> uses = 0;            ///< of all threads

    bool is_child() const { return process != getpid(); }
    void finish_all() {
        if (is_child()) return;
        const std::lock_guard lock(mutex);
        is_ending = true;
        for (Worker* worker : all) worker->finish();
    }
    void await_uses() const;
};

namespace {
/// This thread's uses: an error handler of Xlib may end the program within one.
thread_local int own_uses = 0;
}  // namespace

void Background::Living::await_uses() const {
    using namespace std::chrono_literals;
    if (is_child()) return;
    const auto end = std::chrono::steady_clock::now() + 2s;
    while (uses > own_uses && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(1ms);
}

Background::Living& Background::living() {
    static Living& living = *new Living;
    return living;
}

/// After the program's exit handlers. Threads of the program may draw until the process is gone.
const struct Background::AtExit {
    ~AtExit() {
        if (other_threads_are_gone) return;
        Background::living().finish_all();
        Background::living().await_uses();
        end_parallel_loops();
    }
} at_exit;

Background::Use::Use() {
    ++own_uses;
    ++living().uses;
    allowed_ = !living().is_ending;
}

Background::Use::~Use() {
    --living().uses;
    --own_uses;
}

bool Background::is_available() {
    return !other_threads_are_gone && !living().is_ending && !living().is_child();
}

Background::Background() {
    {
        const BlockedSignals blocked;
        worker_ = std::make_unique<Worker>();
    }
    const std::lock_guard lock(living().mutex);
    living().all.insert(worker_.get());
}

Background::~Background() {
    if (living().is_child()) {
        static_cast<void>(worker_.release());  // its thread is not there to be ended
        return;
    }
    const std::lock_guard lock(living().mutex);
    living().all.erase(worker_.get());
}

void Background::start(std::function<void()> work) {
    std::unique_lock lock(living().mutex);
    if (!living().is_ending) return worker_->start(std::move(work));
    lock.unlock();
    work();
}

void Background::wait() {
    if (living().is_child()) return;
    worker_->finish();
    if (const std::exception_ptr failure = std::exchange(worker_->failure, nullptr))
        std::rethrow_exception(failure);
}

}  // namespace gw::gl
