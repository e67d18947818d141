#include "bench/growth/scenes.h"

#include "gw/error.h"
#include "scene/read_scene.h"

#include <fmt/format.h>

namespace gw::growth {
namespace {

template <class Part>
std::string repeated(int amount, std::string text, const Part& part) {
    for (int i = 0; i < amount; ++i) text += part(i);
    return text;
}

std::string boxes(int amount) {
    return repeated(
        amount, "[camera]\neye = [0, 80, 200]\n[[light]]\ndirection = [-1, -2, -1]\n", [](int i) {
            return fmt::format(
                "[[object]]\nname = 'b{}'\nshape = 'box'\nwidth = 0.5\n"
                "translate = [{}, {}, {}]\n",
                i, 1.5 * (i % 100 - 50), 1.5 * (i / 100 % 100 - 50), -1.5 * (i / 10000));
        });
}

/// Every light names an object of its own.
std::string lights(int amount) {
    return repeated(amount, "", [](int i) {
        return fmt::format(
            "[[object]]\nname = 'b{0}'\nshape = 'box'\n"
            "[[light]]\nposition = [{0}, 9, 0]\nonly = ['b{0}']\n",
            i);
    });
}

std::string materials(int amount) {
    return repeated(amount, "", [](int i) {
        return fmt::format(
            "[material.m{0}]\nKd = [0.5, 0.25, 1]\n[[object]]\nshape = 'box'\nmaterial = 'm{0}'\n",
            i);
    });
}

/// One array on one line: too long, which is an error after it was read.
std::string numbers(int amount) {
    return repeated(amount, "background = [", [](int i) { return fmt::format("{}.5, ", i); }) +
           "]\n";
}

std::string groups(int amount) {
    return repeated(amount, "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
                    [](int i) { return fmt::format("g part{}\nf 1 2 3\n", i); });
}

/// Faces around one point, in directions all over a sphere.
std::string fan(int amount, bool with_groups) {
    return repeated(amount, "v 0 0 0\n", [with_groups](int i) {
        const int x = i * 7919 % 2001 - 1000, y = i * 104729 % 1999 - 999, z = i % 1013 - 506;
        return fmt::format("{}v {} {} {}\nv {} {} {}\nf 1 -1 -2\n",
                           with_groups ? fmt::format("s {}\n", i + 1) : "", x, y, z, y, z, x + 1);
    });
}

std::string vertices(int amount) {
    return repeated(amount, "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
                    [](int i) { return fmt::format("vt {}\nf 1/-1 2 3\n", i); });
}

}  // namespace

std::vector<SceneSweep> scene_sweeps() {
    const std::vector<double> amounts{1000, 10000, 100000, 1000000};
    return {
        {"boxes", amounts, "boxes.toml", boxes},
        {"named-lights", {1000, 10000, 100000}, "lights.toml", lights},
        {"materials", {1000, 10000, 100000}, "materials.toml", materials},
        {"numbers", amounts, "numbers.toml", numbers},
        {"groups", amounts, "groups.obj", groups},
        {"smoothing-groups", amounts, "smooth.obj", [](int n) { return fan(n, true); }},
        {"faces-at-a-point", amounts, "fan.obj", [](int n) { return fan(n, false); }},
        {"vertices-at-a-point", amounts, "vertices.obj", vertices},
    };
}

void read_swept(const std::string& path) {
    try {
        scene::read_scene(path);
    } catch (const Error&) {  // numbers
    }
}

}  // namespace gw::growth
