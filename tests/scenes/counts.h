// What the hidden-surface algorithms count in a scene.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/run/compare.h"
#include "scene/draw/fit.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace gw {

using AllCounts = std::map<std::string, hiddensurface::Counts>;

/// Of every algorithm.
inline AllCounts counts_of(scene::Scene s, int width, int height) {
    scene::add_defaults(s, width, height);
    const scene::View view = scene::make_view(s, width, height);
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    const hiddensurface::Input input = hiddensurface::make_input(s, view, vgx());
    hiddensurface::StepLog none;
    AllCounts counts;
    for (const hiddensurface::Algorithm& algorithm : hiddensurface::algorithms())
        counts[algorithm.name] = hiddensurface::run_on(*machine, algorithm, input, none).counts;
    return counts;
}

inline void expect_same_counts(const AllCounts& a, const AllCounts& b, const std::string& what) {
    for (const auto& [name, counts] : a)
        for (const auto& [count, member] : hiddensurface::count_names())
            EXPECT_EQ(counts.*member, b.at(name).*member) << what << ", " << name << ", " << count;
}

}  // namespace gw
