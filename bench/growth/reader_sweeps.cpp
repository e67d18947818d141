#include "bench/growth/sweep.h"
#include "gw/error.h"
#include "scene/toml/read_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

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

/// Every light names another object.
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

/// The file of a sweep, for as long as it is read.
struct SweptFile {
    std::filesystem::path path;
    SweptFile(const std::string& name, const std::string& text)
        : path(std::filesystem::temp_directory_path() /
               fmt::format("growth-{}-{}", getpid(), name)) {
        std::ofstream(path) << text;
    }
    ~SweptFile() { std::filesystem::remove(path); }
    void read() const {
        try {
            scene::read_scene(path.string());
        } catch (const Error&) {  // numbers
        }
    }
};

struct File {
    std::string name;  ///< the extension chooses the reader
    std::function<std::string(int amount)> text;
};

Sweep sweep(const std::string& name, const std::vector<int>& amounts, const File& file) {
    Sweep made{"read-" + name, name, {}};
    for (const int amount : amounts)
        made.steps.push_back({double(amount), [amount, file](int repeats) {
                                  const SweptFile swept(file.name, file.text(amount));
                                  return least_time(repeats, [&] { swept.read(); });
                              }});
    return made;
}

}  // namespace

std::vector<Sweep> reader_sweeps() {
    const std::vector<int> large{1000, 10000, 100000, 1000000}, small{1000, 10000, 100000};
    return {
        sweep("boxes", large, {"boxes.toml", boxes}),
        sweep("named-lights", small, {"lights.toml", lights}),
        sweep("materials", small, {"materials.toml", materials}),
        sweep("numbers", large, {"numbers.toml", numbers}),
        sweep("groups", large, {"groups.obj", groups}),
        sweep("smoothing-groups", large, {"smooth.obj", [](int n) { return fan(n, true); }}),
        sweep("faces-at-a-point", large, {"fan.obj", [](int n) { return fan(n, false); }}),
        sweep("vertices-at-a-point", large, {"vertices.obj", vertices}),
    };
}

}  // namespace gw::growth
