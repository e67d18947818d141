// gw-exactness: runs the fixed lists and random ones, and prints a line `scene pass plane digest`
// for each plane. Every compiler and processor must give the lines of digests.txt. Does not compare
// them: tests/exactness/compare does. Exit 1 for an error, 2 for usage.
#include "gw/error.h"
#include "gw/fast/simd/simd_target.h"
#include "gw/names.h"
#include "tests/exactness/pictures.h"
#include "tests/fuzz/check/suite_digest.h"
#include "tests/fuzz/run.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

namespace gw::exactness {
namespace {

/// "Color": the table's word for a plane.
std::string column_of(Plane plane) {
    std::string name = name_of(plane);
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

void print_pass(const Picture& picture, const PassReport& pass) {
    std::string name = pass.name;
    for (char& c : name) c = c == ' ' ? '-' : c;
    for (const Plane plane : every_plane)
        if (pass.digested & mask_of(plane))
            fmt::print("{} {} {} {}\n", picture.name, name, column_of(plane),
                       to_string(pass.digests[std::size_t(plane)]));
    fmt::print("{} {} counters {}\n", picture.name, name, fuzz::counters_digest(pass.counters));
}

void print_pictures(const fuzz::MachineMaker& make) {
    for (const Picture& picture : pictures()) {
        const auto machine = make({picture.profile, picture.width, picture.height, {}}, 0);
        machine->execute(picture.list);
        for (const PassReport& pass : machine->passes()) print_pass(picture, pass);
    }
}

void print_lists(const fuzz::MachineMaker& make, std::uint64_t count) {
    for (const fuzz::Suite& suite : fuzz::suites())
        fmt::print("lists-{} 0-{} all {}\n", suite.name, count,
                   fuzz::suite_digest(suite, 0, count, make));
}

int run(int argc, char** argv) {
    std::string machine = "fast";
    for (int i = 1; i < argc; i += 2) {
        const std::string word = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
        if (word == "--targets") {
            for (const std::string& target : fast::simd_targets()) fmt::print("{}\n", target);
            return 0;
        }
        if (word == "--machine") {
            machine = value;
        } else if (word != "--simd" || !fast::use_simd_target(value)) {
            fmt::print(
                stderr,
                "usage: gw-exactness [--machine reference|fast] [--simd TARGET] [--targets]\n");
            return 2;
        }
    }
    print_pictures(fuzz::machine_named(machine));
    print_lists(fuzz::machine_named(machine), 60);
    return 0;
}

}  // namespace
}  // namespace gw::exactness

int main(int argc, char** argv) {
    try {
        return gw::exactness::run(argc, argv);
    } catch (const gw::Error& e) {
        fmt::print(stderr, "gw-exactness: {}\n", e.what());
        return 1;
    }
}
