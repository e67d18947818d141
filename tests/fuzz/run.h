// Running one list on two machines: command by command, whole, and in pieces. Does not print.
#pragma once

#include "tests/fuzz/case.h"
#include "tests/fuzz/compare.h"

#include <functional>
#include <memory>
#include <optional>

namespace gw::fuzz {

/// Makes a machine for a case; `variant` counts the machines of one case (a fast machine takes
/// other threads and tiles for each).
using MachineMaker = std::function<std::unique_ptr<Machine>(const Case&, int variant)>;

/// "reference", "fast", or one of the faulty machines that test this harness. Throws Error for
/// other names.
MachineMaker machine_named(std::string_view name);
/// The names that machine_named knows.
const std::vector<std::string>& machine_names();

/// How machine b was told the list when it first differed from a.
enum class Split { Commands, Whole, Pieces };
const char* name_of(Split split);

struct Failure {
    Split split = Split::Commands;
    /// after this one: the least prefix of the list that shows a difference
    std::size_t command = 0;
    Difference difference;
};

/// Machine a executes command by command; b command by command, whole, and in random pieces, each
/// compared with a. `finished`, if given, sees machine a at the end of a list without failure.
std::optional<Failure> run_case(const Case& c, const MachineMaker& a, const MachineMaker& b,
                                const std::function<void(Machine&)>& finished = {});

/// The list from command `first`, `count` of them.
CommandList part_of(const CommandList& list, std::size_t first, std::size_t count);

}  // namespace gw::fuzz
