// The target selection of Highway's library, for builds without it: every compiled target runs.
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
