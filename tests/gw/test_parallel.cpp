// gw/parallel: every index once, on as many threads as were asked for, whatever the processor has.
#include "gw/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

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

/// Eight bodies that wait for one another: with fewer threads they would wait in vain.
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

TEST(Parallel, RethrowsAnException) {
    for (const int threads : {1, 4})
        EXPECT_THROW(parallel_for(100, threads,
                                  [](std::size_t i, int) {
                                      if (i == 57) throw std::runtime_error("57");
                                  }),
                     std::runtime_error);
}

}  // namespace
}  // namespace gw
