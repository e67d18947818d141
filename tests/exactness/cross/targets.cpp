// What Highway's own library provides on other systems: here every target that is compiled runs.
// Does not detect anything.
#include <hwy/targets.h>

namespace hwy {

namespace {
int64_t asked_for = 0;
}

int64_t SupportedTargets() { return asked_for != 0 ? asked_for : int64_t{HWY_TARGETS}; }
void SetSupportedTargetsForTest(int64_t targets) { asked_for = targets; }
ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

}  // namespace hwy
