// Runs a list on two machines: command by command, whole, and in pieces. Does not print.
#pragma once

#include "tests/fuzz/check/compare.h"
#include "tests/fuzz/suites.h"

#include <functional>
#include <memory>
#include <optional>

namespace gw::fuzz {

/// Makes a machine for a case. `variant` counts the machines of one case; each variant of the fast
/// machine has other threads and tiles.
using MachineMaker = std::function<std::unique_ptr<Machine>(const Case&, int variant)>;

/// "reference", "fast", or one of the faulty machines that test this harness. Throws Error for
/// other names.
MachineMaker machine_named(std::string_view name);
/// The names that machine_named knows.
const std::vector<std::string>& machine_names();

/// The division of the list that machine b executed when it first differed from a.
enum class Split { Commands, Whole, Pieces };
const char* name_of(Split split);

struct Failure {
    Split split = Split::Commands;
    /// the last command of the shortest prefix that shows a difference
    std::size_t command = 0;
    Difference difference;
};

/// Machine a executes command by command. Machine b executes command by command, whole, and in
/// random pieces; each is compared with a. `finished` is called with machine a after a good list.
std::optional<Failure> run_case(const Case& c, const MachineMaker& a, const MachineMaker& b,
                                const std::function<void(Machine&)>& finished = {});

/// The list from command `first`, `count` of them.
CommandList part_of(const CommandList& list, std::size_t first, std::size_t count);

}  // namespace gw::fuzz
