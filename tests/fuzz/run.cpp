#include "tests/fuzz/run.h"

#include <algorithm>

namespace gw::fuzz {
namespace {

void execute_in_pieces(Machine& machine, const CommandList& list) {
    Random random(list.commands.size());
    for (std::size_t i = 0; i < list.commands.size();) {
        const std::size_t count =
            std::min(list.commands.size() - i, std::size_t(random.between(1, 6)));
        machine.execute(part_of(list, i, count));
        i += count;
    }
}

void execute(Machine& machine, const CommandList& list, Split split) {
    switch (split) {
        case Split::Commands:
            for (std::size_t i = 0; i < list.commands.size(); ++i)
                machine.execute(part_of(list, i, 1));
            return;
        case Split::Whole: machine.execute(list); return;
        case Split::Pieces: execute_in_pieces(machine, list); return;
    }
}

std::optional<Difference> difference_of(const Case& c, const CommandList& list,
                                        const MachineMaker& a, const MachineMaker& b, Split split) {
    const auto machine_a = a(c, 0), machine_b = b(c, static_cast<int>(split));
    execute(*machine_a, list, Split::Commands);
    execute(*machine_b, list, split);
    return first_difference(*machine_a, *machine_b);
}

/// The shortest prefix that differs under this split.
Failure shortest_failure(const Case& c, const MachineMaker& a, const MachineMaker& b, Split split,
                         Difference whole) {
    for (std::size_t count = 1; count < c.list.commands.size(); ++count)
        if (auto difference = difference_of(c, part_of(c.list, 0, count), a, b, split))
            return {split, count - 1, *difference};
    return {split, c.list.commands.size() - 1, std::move(whole)};
}

}  // namespace

const char* name_of(Split split) {
    switch (split) {
        case Split::Commands: return "command by command";
        case Split::Whole: return "the whole list at once";
        case Split::Pieces: return "the list in pieces";
    }
    return "";
}

CommandList part_of(const CommandList& list, std::size_t first, std::size_t count) {
    const auto begin = list.commands.begin() + static_cast<std::ptrdiff_t>(first);
    return {{begin, begin + static_cast<std::ptrdiff_t>(count)}};
}

std::optional<Failure> run_case(const Case& c, const MachineMaker& a, const MachineMaker& b,
                                const std::function<void(Machine&)>& finished) {
    const auto machine_a = a(c, 0), machine_b = b(c, static_cast<int>(Split::Commands));
    for (std::size_t i = 0; i < c.list.commands.size(); ++i) {
        machine_a->execute(part_of(c.list, i, 1));
        machine_b->execute(part_of(c.list, i, 1));
        if (auto difference = first_difference(*machine_a, *machine_b))
            return Failure{Split::Commands, i, *difference};
    }
    for (const Split split : {Split::Whole, Split::Pieces}) {
        const auto machine = b(c, static_cast<int>(split));
        execute(*machine, c.list, split);
        if (auto difference = first_difference(*machine_a, *machine))
            return shortest_failure(c, a, b, split, *difference);
    }
    if (finished) finished(*machine_a);
    return std::nullopt;
}

}  // namespace gw::fuzz
