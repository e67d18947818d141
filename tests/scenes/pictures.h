// The small pictures of a scene by every renderer, and how far two of them differ.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/run/scan_line_renderer.h"
#include "itembuffer/adaptive.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "multipass/frame/driver.h"
#include "scene/draw/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gw {

using Picture = std::vector<Rgba>;
using Pictures = std::map<std::string, Picture>;

inline Pictures pictures_of(scene::Scene s, int width, int height) {
    scene::add_defaults(s, width, height);
    const scene::View view = scene::make_view(s, width, height);
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    Pictures pictures;
    const auto draw = [&](const std::string& name, const std::function<void()>& by) {
        by();
        pictures[name] = machine->planes().color;
    };
    if (s.lights.size() <= 8)  // more are refused
        draw("hardware", [&] {
            multipass::render(*machine, s, view, {.renderer = multipass::Renderer::Hardware});
        });
    draw("multipass", [&] { itembuffer::render(*machine, s, view, {}, {}); });
    draw("scanline",
         [&] { machine->execute(hiddensurface::scan_line_picture(s, view, machine->profile())); });
    draw("raytrace",
         [&] { itembuffer::superpose_ray_traced(*machine, s, view, 1, {.threads = 1}, false); });
    draw("adaptive", [&] { itembuffer::render_adaptive(*machine, s, view, 1, {.threads = 1}); });
    return pictures;
}

/// Pixels that differ by more than `units` in a channel.
inline int differing(const Picture& a, const Picture& b, int units = 0) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        bool differs = false;
        for (std::size_t k = 0; k < 3; ++k)
            differs = differs || std::abs(int(a[i][k]) - int(b[i][k])) > units;
        count += differs;
    }
    return count;
}

struct Bound {
    int pixels = 0, units = 0;
    int ray_units = 0;  ///< rays meet faces at points in double, which round otherwise elsewhere
    int one_in = 31;    ///< so many pixels of the picture at least, the scene is seen
};
inline void expect_alike(const Pictures& a, const Pictures& b, const std::string& what,
                         const Bound& bound = {}) {
    for (const auto& [name, picture] : a) {
        const bool rays = name == "raytrace" || name == "adaptive";
        const int units = rays ? std::max(bound.units, bound.ray_units) : bound.units;
        EXPECT_LE(differing(picture, b.at(name), units), bound.pixels) << what << ", " << name;
        const Picture background(picture.size(), picture.front());
        EXPECT_GE(differing(picture, background) * bound.one_in, int(picture.size()))
            << what << ", " << name << ": an empty picture";
    }
}

}  // namespace gw
