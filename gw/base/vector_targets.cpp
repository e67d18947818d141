// The vector instructions that this processor has, as Highway asks for them when it chooses among
// kernels. Its shared library, which answers that too, measures clocks for 4 ms whenever a program
// starts. The names are not exported: a program may have that library besides. What it includes
// comes first, because the standard library's names are not hidden.
#include <atomic>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#pragma GCC visibility push(hidden)
#include <hwy/targets.h>
#pragma GCC visibility pop

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace hwy {

namespace {

int64_t asked_for = 0;

#if HWY_ARCH_X86
bool has_half_floats() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}

/// Each target with the instructions that HWY_TARGET_STR_... lists.
int64_t detected() {
    __builtin_cpu_init();
    const auto has = [](auto... known) { return (known && ...); };
    int64_t targets = HWY_SCALAR | HWY_EMU128;
    if (!has(__builtin_cpu_supports("sse4.2"), __builtin_cpu_supports("pclmul"),
             __builtin_cpu_supports("aes")))
        return targets;
    targets |= HWY_SSSE3 | HWY_SSE4;
    if (!has(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("bmi"),
             __builtin_cpu_supports("bmi2"), __builtin_cpu_supports("fma"), has_half_floats()))
        return targets;
    targets |= HWY_AVX2;
    if (has(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512vl"),
            __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512bw")))
        targets |= HWY_AVX3;
    return targets;
}
#else
/// Other processors than x86 have one target.
int64_t detected() { return HWY_TARGETS; }
#endif

}  // namespace

int64_t SupportedTargets() {
    static const int64_t found = detected();
    return asked_for != 0 ? asked_for : found;
}
void SetSupportedTargetsForTest(int64_t targets) { asked_for = targets; }
ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

/// What Highway's checks in builds without optimization call.
void Abort(const char* file, int line, const char* format, ...) {
    std::fprintf(stderr, "%s:%d: ", file, line);
    std::va_list values;
    va_start(values, format);
    std::vfprintf(stderr, format, values);
    va_end(values);
    std::fputc('\n', stderr);
    std::abort();
}

}  // namespace hwy
