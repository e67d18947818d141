#include "gw/error.h"
#include "tests/fuzz/check/faulty.h"
#include "tests/fuzz/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace gw::fuzz {
namespace {

std::unique_ptr<Machine> reference(const Case& c, int) {
    return make_reference(c.profile, c.width, c.height);
}

/// Variants 0 to 8 have 1 to 9 threads and tiles of 16, 64 and 32 pixels.
std::unique_ptr<Machine> fast(const Case& c, int variant) {
    constexpr int log2_tiles[] = {4, 6, 5};
    return make_fast(c.profile, c.width, c.height,
                     {.threads = 1 + variant, .log2_tile = log2_tiles[variant % 3]});
}

const std::map<std::string, MachineMaker, std::less<>>& machines() {
    static const std::map<std::string, MachineMaker, std::less<>> all{
        {"reference", reference},
        {"fast", fast},
        {"faulty-pixel",
         [](const Case& c, int) { return make_faulty(reference(c, 0), Fault::Pixel); }},
        {"faulty-counter",
         [](const Case& c, int) { return make_faulty(reference(c, 0), Fault::Counter); }},
        {"faulty-split",
         [](const Case& c, int) { return make_faulty(reference(c, 0), Fault::Split); }},
    };
    return all;
}

}  // namespace

const std::vector<std::string>& machine_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const auto& [name, maker] : machines()) out.push_back(name);
        return out;
    }();
    return names;
}

MachineMaker machine_named(std::string_view name) {
    const auto found = machines().find(name);
    if (found == machines().end())
        throw Error(fmt::format("unknown machine '{}'; expected {}", name,
                                fmt::join(machine_names(), ", ")));
    return found->second;
}

}  // namespace gw::fuzz
