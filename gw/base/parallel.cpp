#include "gw/base/parallel.h"

#include "gw/base/blocked_signals.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <exception>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif
#ifdef __linux__
#include <pthread.h>
#endif

#ifdef GW_THREADS_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif
#include <thread>
#include <vector>

namespace gw {

int hardware_threads() {
    static const unsigned n = std::thread::hardware_concurrency();  // reads files of the system
    return n > 0 ? static_cast<int>(n) : 1;
}

namespace {

/// Whether the modes are those that a program starts with. Reading one register is cheap; saving
/// and restoring all modes takes as long as a small body.
bool is_default_environment() {
#ifdef __SSE2_MATH__
    constexpr unsigned flags = 0x3F, initial = 0x1F80;
    return (_mm_getcsr() & ~flags) == initial;
#else
    return false;
#endif
}

}  // namespace

FloatEnvironment::FloatEnvironment() : changed_(!is_default_environment()) {
    static_assert(sizeof(std::fenv_t) <= sizeof saved_);
    if (!changed_) return;
    std::fegetenv(new (saved_) std::fenv_t);
    std::fesetenv(FE_DFL_ENV);
}

FloatEnvironment::~FloatEnvironment() {
    if (changed_) std::fesetenv(std::launder(reinterpret_cast<std::fenv_t*>(saved_)));
}

namespace {

void serial_for(std::size_t count, const std::function<void(std::size_t, int)>& body) {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < count; ++i) body(i, 0);
}

/// The number of `wanted` threads that the system starts, the calling one included. They wait until
/// all have started. If it refuses one, returns half of them: their work needs memory too.
int count_threads(int wanted) {
    std::promise<void> end;
    const std::shared_future<void> ended = end.get_future();
    // Not std::atomic::wait: where the system has no futex, g++ 12's may sleep for ever.
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t ready = 0;
    const auto body = [&, ended] {
        // The C library reserves address space at a thread's first allocation.
        char* const first = new (std::nothrow) char[1000];
        if (first) *static_cast<volatile char*>(first) = 0;
        delete[] first;
        {
            const std::lock_guard lock(mutex);
            ++ready;
        }
        changed.notify_one();
        ended.wait();
    };
    const BlockedSignals blocked;
    std::vector<std::thread> started;
    started.reserve(std::size_t(wanted));
    try {
        while (int(started.size()) < wanted - 1) {
            started.emplace_back(body);
            std::unique_lock lock(mutex);
            changed.wait(lock, [&] { return ready == started.size(); });
        }
    } catch (const std::exception&) {
        // A limit of the system is reached: of threads or of memory.
    }
    end.set_value();
    for (std::thread& thread : started) thread.join();
    const int running = int(started.size()) + 1;
    return running < wanted ? std::max(1, running / 2) : wanted;
}

/// The number of threads to use if the caller wants `wanted`. If the system refuses oneTBB a
/// thread, the program ends. So each new maximum is first tried here.
int granted_threads(int wanted) {
    static std::mutex mutex;
    static int granted = 1, refused = std::numeric_limits<int>::max();
    const std::lock_guard lock(mutex);
    if (wanted > granted && wanted < refused) {
        const int count = count_threads(wanted);
        if (count < wanted) refused = wanted;
        granted = std::max(granted, count);
    }
    return std::min(wanted, granted);
}

#ifdef GW_THREADS_TBB

// What they keep is never destroyed: other threads draw while the program ends.

/// oneTBB starts no more threads than there are processors unless its limit is raised.
void allow_threads(int threads) {
    using Control = tbb::global_control;
    static std::mutex mutex;
    static auto& allowed = *new std::unique_ptr<Control>;
    const std::lock_guard lock(mutex);
    const auto most = std::size_t(threads);
    if (Control::active_value(Control::max_allowed_parallelism) >= most) return;
    allowed.reset();
    allowed = std::make_unique<Control>(Control::max_allowed_parallelism, most);
}

/// Arenas that no call uses now. oneTBB's threads join a new arena late or never, so arenas are
/// kept for later calls.
class Arenas {
public:
    using Arena = std::unique_ptr<tbb::task_arena>;

    Arena take(int threads) {
        const std::lock_guard lock(mutex_);
        std::vector<Arena>& free = free_[threads];
        if (free.empty()) return make(threads);
        Arena arena = std::move(free.back());
        free.pop_back();
        return arena;
    }
    void give_back(int threads, Arena arena) {
        const std::lock_guard lock(mutex_);
        free_[threads].push_back(std::move(arena));
    }

private:
    /// With work for all, so that oneTBB starts its threads here.
    static Arena make(int threads) {
        const BlockedSignals blocked;
        auto arena = std::make_unique<tbb::task_arena>(threads);
        arena->execute([threads] { tbb::parallel_for(0, threads, [](int) {}); });
        return arena;
    }

    std::mutex mutex_;
    std::map<int, std::vector<Arena>> free_;
};

void threaded_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& body) {
    static Arenas& arenas = *new Arenas;
    allow_threads(threads);
    Arenas::Arena arena = arenas.take(threads);
    arena->execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                const FloatEnvironment environment;
                const int worker = tbb::this_task_arena::current_thread_index();
                for (std::size_t i = range.begin(); i < range.end(); ++i) body(i, worker);
            },
            tbb::simple_partitioner());
    });
    arenas.give_back(threads, std::move(arena));
}

#else

/// Workers take the next index until none is left.
struct Work {
    std::size_t count;
    const std::function<void(std::size_t, int)>& body;
    std::atomic<std::size_t> next{0};
    std::mutex mutex{};
    std::exception_ptr failure{};

    void run(int worker) {
        const FloatEnvironment environment;
        try {
            for (std::size_t i = next++; i < count; i = next++) body(i, worker);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    }
};

void threaded_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& body) {
    Work work{count, body};
    std::vector<std::thread> pool;
    pool.reserve(std::size_t(threads));
    try {
        const BlockedSignals blocked;
        for (int worker = 1; worker < threads; ++worker)
            pool.emplace_back([&work, worker] { work.run(worker); });
    } catch (const std::system_error&) {
        // The threads that did start take all indices.
    }
    work.run(0);
    for (std::thread& thread : pool) thread.join();
    if (work.failure) std::rethrow_exception(work.failure);
}

#endif

/// A call of threaded_for.
class ThreadedLoop {
public:
    ThreadedLoop() { ++all_, ++of_thread_; }
    ~ThreadedLoop() {
        --of_thread_;
        --all_;
        if (ended_) all_.notify_all();
    }
    ThreadedLoop(const ThreadedLoop&) = delete;
    ThreadedLoop& operator=(const ThreadedLoop&) = delete;

    static bool have_ended() { return ended_; }
    /// A child of fork() has none of its parent's threads, and oneTBB does not know it.
    static void end_in_children() {
#ifdef __linux__
        [[maybe_unused]] static const int registered = pthread_atfork(nullptr, nullptr, [] {
            ended_ = true;
            all_ = of_thread_;
        });
#endif
    }
    /// A signal handler's exit() may have interrupted loops of this thread.
    static void end_all() {
        ended_ = true;
        for (int n = all_; n > of_thread_; n = all_) all_.wait(n);
    }

private:
    static inline std::atomic<int> all_ = 0;
    static inline std::atomic<bool> ended_ = false;
    static inline thread_local int of_thread_ = 0;
};

}  // namespace

void end_parallel_loops() { ThreadedLoop::end_all(); }

void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& body) {
    if (threads <= 0) threads = hardware_threads();
    if (threads == 1 || count <= 1 || ThreadedLoop::have_ended()) return serial_for(count, body);
    threads = granted_threads(threads);
    if (threads == 1) return serial_for(count, body);
    {
        ThreadedLoop::end_in_children();
        const ThreadedLoop loop;
        if (!ThreadedLoop::have_ended()) return threaded_for(count, threads, body);
    }
    serial_for(count, body);
}

}  // namespace gw
