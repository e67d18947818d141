// gw-fuzz: seeded random lists on two machines, compared after every command.
// Exit 0: no difference; 1: an error, or lists too uniform to prove anything; 2: usage; 3: a
// difference, with the command that repeats it.
#include "gw/error.h"
#include "gw/fast/simd/simd_target.h"
#include "tests/fuzz/check/describe.h"
#include "tests/fuzz/check/diversity.h"
#include "tests/fuzz/check/explain.h"
#include "tests/fuzz/check/shrink.h"
#include "tests/fuzz/check/suite_digest.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::fuzz {
namespace {

struct Arguments {
    std::vector<std::string> suites;
    std::vector<std::uint64_t> range{0, 100};
    std::string machine_a = "reference", machine_b = "fast", simd;
    bool list = false, shrink = false, print = false, digest = false;
};

/// Lists are valid, so a list that throws is a failure of the generator.
std::optional<Failure> run_list(const Arguments& arguments, const Suite& suite, std::uint64_t index,
                                const Case& c, Diversity& reached) {
    try {
        return run_case(c, machine_named(arguments.machine_a), machine_named(arguments.machine_b),
                        [&](Machine& machine) { reached.add(c, machine); });
    } catch (const std::exception& e) {
        throw Error(fmt::format(
            "list {} of suite {}: {}\nrepeat: build/release/bin/gw-fuzz --suite {} --range {} {}",
            index, suite.name, e.what(), suite.name, index, index + 1));
    }
}

int run_suite(const Arguments& arguments, const Suite& suite) {
    Diversity reached;
    for (std::uint64_t i = arguments.range[0]; i < arguments.range[1]; ++i) {
        Case c = make_case(suite, i);
        if (arguments.print) fmt::print("{}", describe(c));
        auto failure = run_list(arguments, suite, i, c, reached);
        if (!failure) continue;
        if (arguments.shrink) {
            const MachineMaker a = machine_named(arguments.machine_a),
                               b = machine_named(arguments.machine_b);
            c = shrink(c, a, b);
            failure = run_case(c, a, b);
            fmt::print("left after leaving out:\n{}", describe(c));
        }
        fmt::print("{}", report(suite, i, c, *failure, arguments.machine_a, arguments.machine_b));
        if (!arguments.simd.empty()) fmt::print("with --simd {} too\n", arguments.simd);
        return 3;
    }
    fmt::print("{:18} {}\n", suite.name, summary(reached));
    const std::string gaps = missing(reached, suite);
    if (gaps.empty()) return 0;
    fmt::print("{}: too uniform:{}\n", suite.name, gaps);
    return 1;
}

std::vector<const Suite*> chosen(const std::vector<std::string>& names) {
    std::vector<const Suite*> out;
    for (const Suite& suite : suites())
        if (names.empty() || std::find(names.begin(), names.end(), suite.name) != names.end())
            out.push_back(&suite);
    return out;
}

int run(const Arguments& arguments) {
    if (arguments.list) {
        for (const Suite& suite : suites()) fmt::print("{:18} {}\n", suite.name, suite.about);
        return 0;
    }
    int result = 0;
    fast::use_simd_target(arguments.simd);
    for (const Suite* suite : chosen(arguments.suites)) {
        if (arguments.digest)
            fmt::print("{:18} {}\n", suite->name,
                       suite_digest(*suite, arguments.range[0], arguments.range[1],
                                    machine_named(arguments.machine_b)));
        else
            result = std::max(result, run_suite(arguments, *suite));
        std::fflush(stdout);
    }
    return result;
}

std::vector<std::string> suite_names() {
    std::vector<std::string> names;
    for (const Suite& suite : suites()) names.push_back(suite.name);
    return names;
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("--suite", a.suites, "suites, by name; default all")
        ->check(CLI::IsMember(suite_names()));
    app.add_option("--range", a.range, "lists LO to HI - 1 of each suite; default 0 100")
        ->expected(2);
    app.add_option("--machine-a", a.machine_a, "default reference")
        ->check(CLI::IsMember(machine_names()));
    app.add_option("--machine-b", a.machine_b, "default fast")
        ->check(CLI::IsMember(machine_names()));
    app.add_option("--simd", a.simd,
                   "vector target of the fast machine; default the processor's best")
        ->check(CLI::IsMember(fast::simd_targets()));
    app.add_flag("--list", a.list, "print the suites");
    app.add_flag("--shrink", a.shrink,
                 "leave out of a failing list what can be left out, and print the rest");
    app.add_flag("--print", a.print, "print every list");
    app.add_flag("--digest", a.digest, "only machine b; print one digest for each suite");
}

}  // namespace
}  // namespace gw::fuzz

int main(int argc, char** argv) {
    CLI::App app(
        "Seeded random command lists on two machines: every plane, counter, read-back and digest after "
        "every command.\nExample: gw-fuzz --suite blend stencil --range 0 1000");
    gw::fuzz::Arguments arguments;
    gw::fuzz::add_options(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        return gw::fuzz::run(arguments);
    } catch (const gw::Error& e) {
        fmt::print(stderr, "gw-fuzz: {}\n", e.what());
        return 1;
    }
}
