// The vector instructions that kernels are chosen by.
#include "gw/fast/simd/simd_target.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#if HWY_ARCH_X86

namespace gw::fast {
namespace {

/// The processor's flags, as the kernel lists them; none on another system than Linux on x86.
std::vector<std::string> processor_flags() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("flags")) continue;
        std::istringstream words(line.substr(line.find(':') + 1));
        return {std::istream_iterator<std::string>(words), {}};
    }
    return {};
}

bool has(const std::vector<std::string>& flags, const std::vector<std::string>& wanted) {
    return std::ranges::all_of(
        wanted, [&](const std::string& f) { return std::ranges::count(flags, f) != 0; });
}

TEST(SimdTarget, IsOneThatTheProcessorHas) {
    const std::vector<std::string> flags = processor_flags();
    if (flags.empty()) GTEST_SKIP() << "no flags in /proc/cpuinfo";
    const std::vector<std::string> names = simd_targets();
    const bool avx2 =
        has(flags, {"sse4_2", "pclmulqdq", "aes", "avx2", "bmi1", "bmi2", "fma", "f16c"});
    const bool avx3 = avx2 && has(flags, {"avx512f", "avx512vl", "avx512dq", "avx512bw"});
    EXPECT_EQ(std::ranges::count(names, "AVX2"), avx2 && (HWY_TARGETS & HWY_AVX2) != 0);
    EXPECT_EQ(std::ranges::count(names, "AVX3"), avx3 && (HWY_TARGETS & HWY_AVX3) != 0);
}

}  // namespace
}  // namespace gw::fast

#endif
