// gw-failing-allocation K ARGUMENT...: runs gw with these arguments; the K-th operator new after
// the start of main fails. With K = 0 none fails, and their number is written to standard error.
#include "apps/command/command.h"
#include "apps/command/early_end.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};
long failing = 0;  // 0: none

void count() {
    if (++allocations == failing) throw std::bad_alloc();
}

void* checked(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    count();
    return checked(std::malloc(size > 0 ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    count();
    const auto unit = static_cast<std::size_t>(alignment);
    return checked(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

int main(int count, char** words) {
    if (count < 2) return std::fprintf(stderr, "usage: %s K ARGUMENT...\n", words[0]), 2;
    const std::vector<std::string> arguments(words + 2, words + count);
    gw::apps::end_clearly_on_terminate();
    allocations = 0;
    failing = std::strtol(words[1], nullptr, 10);
    const int code = gw::apps::run(arguments);
    if (failing == 0) std::fprintf(stderr, "%ld\n", allocations.load());
    return code;
}
