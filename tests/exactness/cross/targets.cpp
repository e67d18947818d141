// The target selection of Highway's library, for builds without it. Other processors than x86 have
// one target.
#include <hwy/targets.h>

namespace hwy {

namespace {

int64_t asked_for = 0;

int64_t detected() {
#if HWY_ARCH_X86
    __builtin_cpu_init();
    const auto has = [](auto... known) { return (known && ...); };
    int64_t targets = HWY_SCALAR | HWY_EMU128;
    if (has(__builtin_cpu_supports("sse4.2"), __builtin_cpu_supports("pclmul"),
            __builtin_cpu_supports("aes")))
        targets |= HWY_SSSE3 | HWY_SSE4;
    if (has(targets & HWY_SSE4, __builtin_cpu_supports("avx2"), __builtin_cpu_supports("bmi"),
            __builtin_cpu_supports("bmi2"), __builtin_cpu_supports("fma")))
        targets |= HWY_AVX2;
    return targets;
#else
    return HWY_TARGETS;
#endif
}

}  // namespace

int64_t SupportedTargets() {
    static const int64_t found = detected() & HWY_TARGETS;
    return asked_for != 0 ? asked_for : found;
}
void SetSupportedTargetsForTest(int64_t targets) { asked_for = targets; }
ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

}  // namespace hwy
