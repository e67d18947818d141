// All lengths are in metres: ten bays of 2.6, an arcade below, four floors above, a square with
// lanterns and a fountain before it.
#include "scenes/make_lamps/lamps.h"

#include <fmt/format.h>

namespace gw::lamps {
namespace {

constexpr int bays = 10, floors = 4;
constexpr double bay = 2.6, arcade = 3.4, storey = 2.7, length = bays * bay,
                 height = arcade + floors * storey;

constexpr const char* head =
    R"(# A building with 100 lamps [K3.3]: point lights with attenuation, twelve of them with shadows. The machine knows eight in a
# pass; multi-pass has no limit. Written by: build/release/bin/make-lamps scenes/lamps.toml
#     gw render scenes/lamps.toml -o lamps.png
name = "lamps"
background = [0.02, 0.03, 0.08]

[camera]
eye = [-9, 6.2, 38]
at = [-0.1, 6, 0]
fov = 33

[material.wall]
Ka = [0.5, 0.55, 0.8]
Kd = [0.85, 0.78, 0.66]

[material.cornice]
Ka = [0.5, 0.55, 0.8]
Kd = [0.9, 0.86, 0.78]

[material.window]
Ka = 0
Kd = [0.1, 0.1, 0.12]
Ke = [0.2, 0.14, 0.06]

[material.dark_window]
Ka = 0.2
Kd = [0.1, 0.1, 0.14]

[material.square]
Ka = [0.4, 0.45, 0.7]
Kd = [0.8, 0.76, 0.72]
map_Kd = { file = "maps/granite.png", scale = [36, 28] }

[material.stone]
Ka = [0.5, 0.55, 0.8]
Kd = 0.8
Ks = 0.2
Ns = 20

[material.bronze]
Ka = 0.2
Kd = [0.35, 0.55, 0.45]
Ks = 0.6
Ns = 30

[material.warm]
Ka = 0
Kd = 0
Ke = [1, 0.85, 0.55]

[material.cold]
Ka = 0
Kd = 0
Ke = [0.75, 0.9, 1]
)";

std::string triple(double x, double y, double z) {
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", x, y, z);
}

/// A shape with parameters, placed.
std::string object(const std::string& name, const std::string& parameters, const std::string& place,
                   const std::string& material) {
    return fmt::format("\n[[object]]\nname = \"{}\"\n{}\ntranslate = {}\nmaterial = \"{}\"\n", name,
                       parameters, place, material);
}

struct Lamp {
    const char* kind;  ///< its name begins with it
    double x, y, z;
    bool cold = false, shadow = false;
    double strength = 1, reach = 1;  ///< reach: metres to a fifth of the strength
    double radius = 0.1;
};

/// The visible globe, and the light slightly below it, so that its shadow goes upwards.
std::string lamp(const Lamp& l, int number) {
    const std::string name = fmt::format("{} {}", l.kind, number);
    const double r = l.cold ? 0.5 : 1, g = l.cold ? 0.75 : 0.68, b = l.cold ? 1 : 0.32;
    std::string text = fmt::format(
        "\n[[light]]\nname = \"{}\"\nposition = {}\nId = {}\nIs = {}\nattenuation = [0.25, 0, {:.4g}]\n",
        name, triple(l.x, l.y - 2 * l.radius, l.z),
        triple(r * l.strength, g * l.strength, b * l.strength), triple(0.5 * r, 0.5 * g, 0.5 * b),
        4.75 / (l.reach * l.reach));
    if (number == 1) text += "Ia = 0.06\n";
    if (l.shadow) text += "shadow = \"volume\"\n";
    return text +
           object("globe of " + name,
                  fmt::format("shape = \"icosphere\"\nradius = {:.3g}\ndivisions = 2", l.radius),
                  triple(l.x, l.y, l.z), l.cold ? "cold" : "warm");
}

double middle_of(int i) { return -length / 2 + (i + 0.5) * bay; }

std::string building_walls() {
    std::string text;
    text += object(
        "wall",
        fmt::format("shape = \"rectangle\"\nwidth = {:.4g}\ndepth = {:.4g}\ncolumns = 130\nrows = "
                    "70\nrotate = [90, 0, 0]",
                    length, height),
        triple(0, height / 2, 0), "wall");
    text += object(
        "side wall",
        fmt::format(
            "shape = \"rectangle\"\nwidth = {:.4g}\ndepth = 9\ncolumns = 24\nrows = 16\nrotate = [0, 0, 90]",
            height),
        triple(-length / 2, height / 2, -4.5), "wall");
    for (int f = 0; f <= floors; ++f)
        text += object(
            fmt::format("cornice {}", f + 1),
            fmt::format("shape = \"box\"\nwidth = {:.4g}\nheight = {}\ndepth = {}\nsegments = {}",
                        length + 0.3, f == 0 ? 0.35 : 0.18, f == 0 ? 5.2 : 0.5, f == 0 ? 40 : 48),
            triple(0, arcade + f * storey, f == 0 ? 0.0 : 0.1), "cornice");
    return text;
}

std::string windows() {
    std::string text;
    for (int f = 0; f < floors; ++f)
        for (int i = 0; i < bays; ++i)
            text += object(fmt::format("window {} {}", f + 1, i + 1),
                           "shape = \"box\"\nwidth = 1.1\nheight = 1.5\ndepth = 0.12\nsegments = 2",
                           triple(middle_of(i), arcade + f * storey + 1.15, 0.02),
                           (3 * f + 7 * i) % 5 < 2 ? "window" : "dark_window");
    return text;
}

std::string columns() {
    std::string text;
    for (int i = 0; i <= bays; ++i)
        text +=
            object(fmt::format("column {}", i + 1),
                   "shape = \"cylinder\"\nradius = 0.24\nheight = 3.3\nslices = 24\nstacks = 14",
                   triple(-length / 2 + i * bay, 1.65, 2.3), "stone");
    return text;
}

std::string square() {
    return object("square",
                  "shape = \"rectangle\"\nwidth = 44\ndepth = 34\ncolumns = 132\nrows = 102",
                  triple(0, 0, 9), "square") +
           object("basin", "shape = \"bowl\"\nslices = 64\nsegments = 10\nscale = [3.2, 0.9, 3.2]",
                  triple(0, 0, 10.5), "stone") +
           object("vase", "shape = \"vase\"\nslices = 64\nsegments = 14\nscale = 2.6",
                  triple(0, 0.3, 10.5), "bronze");
}

std::string lanterns(int& number) {
    std::string text;
    for (int row = 0; row < 2; ++row)
        for (int i = 0; i < 12; ++i) {
            const double x = -14.3 + i * 2.6, z = row == 0 ? 5.4 : 14.2;
            const bool shadow = row == 1 && (i == 3 || i == 8);
            text +=
                object(fmt::format("post {} {}", row + 1, i + 1),
                       "shape = \"cylinder\"\nradius = 0.05\nheight = 1.1\nslices = 12\nstacks = 4",
                       triple(x, 0.55, z), "stone");
            text += lamp({"lantern", x, 1.25, z, row == 1, shadow, 0.75, 3.2, 0.13}, ++number);
        }
    return text;
}

std::string fountain_lamps(int& number) {
    // Fourteen in a ring: cosines and sines of a 14th of the circle, to five digits, so that no
    // libm is needed.
    constexpr double cosine[] = {1, 0.90097, 0.62349, 0.22252, -0.22252, -0.62349, -0.90097};
    constexpr double sine[] = {0, 0.43388, 0.78183, 0.97493, 0.97493, 0.78183, 0.43388};
    std::string text;
    for (int i = 0; i < 14; ++i) {
        const double sign = i < 7 ? 1 : -1;
        text += lamp({"fountain", sign * 2.3 * cosine[i % 7], 0.3, 10.5 + sign * 2.3 * sine[i % 7],
                      true, false, 0.6, 2.2, 0.07},
                     ++number);
    }
    return text;
}

std::string house_lamps(int& number) {
    std::string text;
    for (int i = 0; i < bays; ++i)
        text += lamp({"arcade", middle_of(i), 2.7, 1.1, false, true, 0.4, 4.6, 0.12}, ++number);
    for (int f = 0; f < floors; ++f)
        for (int i = 0; i < bays; ++i)
            text += lamp(
                {"wall", middle_of(i), arcade + f * storey + 2.2, 0.42, false, false, 0.8, 2, 0.08},
                ++number);
    for (int i = 0; i < 12; ++i)
        text += lamp({"roof", -length / 2 + 1 + i * (length - 2) / 11, height + 0.35, 0.25, true,
                      false, 0.7, 1.8, 0.09},
                     ++number);
    return text;
}

}  // namespace

std::string building() {
    int number = 0;
    std::string text = head + building_walls() + windows() + columns() + square();
    const std::string fountain = fountain_lamps(number), square_lanterns = lanterns(number),
                      house = house_lamps(number);  // numbered in this order by every compiler
    return text + house + square_lanterns + fountain;
}

}  // namespace gw::lamps
