// gw/base/parallel.h: every index once, on the number of threads given, on any processor. The
// arithmetic of docs/manual/numbers.md under any rounding mode of the caller.
#include "gw/base/parallel.h"
#include "gw/machine.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace gw {
namespace {

TEST(Parallel, CallsEveryIndexOnceAndNamesTheWorker) {
    for (const int threads : {1, 2, 3, 8}) {
        std::vector<std::atomic<int>> calls(1000);
        std::atomic<bool> named{true};
        parallel_for(calls.size(), threads, [&](std::size_t i, int worker) {
            calls[i] += 1;
            if (worker < 0 || worker >= threads) named = false;
        });
        for (const std::atomic<int>& c : calls) ASSERT_EQ(c, 1);
        EXPECT_TRUE(named);
    }
}

/// Eight bodies that wait for each other, which takes eight threads.
TEST(Parallel, RunsOnMoreThreadsThanTheProcessorHas) {
    constexpr int threads = 8;
    std::atomic<int> arrived{0};
    std::atomic<bool> in_vain{false};
    parallel_for(threads, threads, [&](std::size_t, int) {
        arrived += 1;
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (arrived < threads && !in_vain) {
            std::this_thread::yield();
            if (std::chrono::steady_clock::now() > until) in_vain = true;
        }
    });
    EXPECT_FALSE(in_vain);
}

/// Bytes of this process.
std::size_t used_address_space() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * std::size_t(sysconf(_SC_PAGESIZE));
}

/// In a separate process whose address space has space for only a few stacks.
TEST(ParallelDeathTest, UsesFewerThreadsWhereTheSystemRefusesThem) {
    if (used_address_space() > std::size_t{200} << 20)
        GTEST_SKIP() << "this program, with sanitizers, reserves too much address space";
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const auto run = [] {
        const rlimit limit{std::size_t{400} << 20, std::size_t{400} << 20};
        setrlimit(RLIMIT_AS, &limit);
        std::atomic<int> calls{0};
        std::atomic<bool> named{true};
        parallel_for(500, 500, [&](std::size_t, int worker) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // others start meanwhile
            calls += 1;
            if (worker < 0 || worker >= 500) named = false;
        });
        std::exit(calls == 500 && named ? 0 : 1);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

/// Children of a process whose threads are in the middle of a loop.
TEST(Parallel, EndsInChildrenToo) {
    std::atomic<bool> ends = false;
    std::thread other([&] {
        while (!ends) parallel_for(64, 4, [](std::size_t, int) {});
    });
    const auto loops = [] {
        std::atomic<int> calls = 0;
        for (int i = 0; i < 100; ++i) parallel_for(16, 4, [&](std::size_t, int) { ++calls; });
        return calls == 1600;
    };
    loops();
    for (int i = 0; i < 40; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            alarm(20);
            const bool all = loops();
            end_parallel_loops();
            _exit(all ? 0 : 1);
        }
        int status = -1;
        waitpid(child, &status, 0);
        ASSERT_EQ(status, 0) << i;
    }
    ends = true;
    other.join();
}

TEST(Parallel, RethrowsAnException) {
    for (const int threads : {1, 4})
        EXPECT_THROW(parallel_for(100, threads,
                                  [](std::size_t i, int) {
                                      if (i == 57) throw std::runtime_error("57");
                                  }),
                     std::runtime_error);
}

/// Rounds upwards and flushes denormals to zero, if the processor can, during its lifetime.
class OtherEnvironment {
public:
    OtherEnvironment() {
        std::fegetenv(&saved_);
        std::fesetround(FE_UPWARD);
#ifdef __SSE2__
        _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
    }
    ~OtherEnvironment() { std::fesetenv(&saved_); }

private:
    std::fenv_t saved_;
};

/// 1 + 2^-60, and half of a denormal.
std::array<double, 2> sensitive() {
    const volatile double one = 1, small = 0x1p-60, denormal = 0x1p-1060;
    return {one + small, denormal / 2};
}

constexpr std::array<double, 2> as_the_manual_says{1, 0x1p-1061};

TEST(FloatEnvironment, HoldsWhileItLivesAndThenIsWhatItWas) {
    const OtherEnvironment other;
    const std::array<double, 2> before = sensitive();
    EXPECT_NE(before, as_the_manual_says);
    {
        const FloatEnvironment environment;
        EXPECT_EQ(sensitive(), as_the_manual_says);
        const FloatEnvironment again;
        EXPECT_EQ(sensitive(), as_the_manual_says);
    }
    EXPECT_EQ(sensitive(), before);
}

TEST(FloatEnvironment, HoldsInEveryBody) {
    const OtherEnvironment other;
    for (const int threads : {1, 4})
        parallel_for(100, threads,
                     [](std::size_t, int) { EXPECT_EQ(sensitive(), as_the_manual_says); });
}

/// Both machines draw the same under any float environment of the caller.
// [R1.2] [R2.1]
TEST(FloatEnvironment, DoesNotReachAPixel) {
    CommandList list;
    list.add(Clear{.planes = all_planes, .color = vec4(0.3f)});
    list.add(
        Draw{.mesh = make_mesh(
                 {.primitive = Primitive::Triangles,
                  .positions = {{-0.9f, -0.7f, 0.1f}, {0.8f, -0.3f, 0.5f}, {0.1f, 0.9f, -0.4f}},
                  .colors = {vec4(0.1f), vec4(0.7f), vec4(1.0f / 3)}})});
    for (const bool fast : {false, true}) {
        const auto machine = [&] {
            return fast ? make_fast(ideal(), 64, 64) : make_reference(ideal(), 64, 64);
        };
        const auto usual = machine(), odd = machine();
        usual->execute(list);
        {
            const OtherEnvironment other;
            odd->execute(list);
        }
        EXPECT_EQ(usual->planes().color, odd->planes().color);
        EXPECT_EQ(usual->planes().depth, odd->planes().depth);
    }
}

}  // namespace
}  // namespace gw
