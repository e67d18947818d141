#include "gw/fast/simd/simd_target.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace gw::fast {

std::vector<std::string> simd_targets() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.emplace_back(hwy::TargetName(target));
    return names;
}

std::string simd_target() {
    const std::vector<std::string> names = simd_targets();
    return names.empty() ? "none" : names.front();
}

bool use_simd_target(const std::string& name) {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    if (name.empty()) return true;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name != hwy::TargetName(target)) continue;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        return true;
    }
    return false;
}

}  // namespace gw::fast
