#include "python/binding/slices.h"

#include "inspect/recording/check_lists.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gw::python {
namespace {

/// Pixels that a slice may have at first: about a tenth of a second on each machine.
constexpr double first_slice_fast = 1 << 27, first_slice_reference = 1 << 20;
/// Slices grow and shrink to take about so many seconds.
constexpr double quick = 0.1, slow = 0.4;
constexpr double triangle_cost = 64;

}  // namespace

SlicedMachine::SlicedMachine(std::unique_ptr<Machine> machine, bool reference, int width,
                             int height)
    : ForwardingMachine(*machine),
      machine_(std::move(machine)),
      width_(width),
      height_(height),
      most_(reference ? first_slice_reference : first_slice_fast) {}

double SlicedMachine::cost(const Command& command) const {
    const double window = double(width_) * double(height_);
    if (const auto* draw = std::get_if<Draw>(&command))
        return window + triangle_cost * double(draw->mesh ? draw->mesh->triangles().size() : 0);
    return std::holds_alternative<SetState>(command) ? 1 : window;
}

std::size_t SlicedMachine::end_of_slice(const CommandList& list, std::size_t first) const {
    double sum = 0;
    std::size_t end = first;
    while (end < list.commands.size() && (end == first || sum < most_))
        sum += cost(list.commands[end++]);
    return end;
}

void SlicedMachine::execute_whole(const CommandList& list) {
    machine_->execute(list);
    inspect::follow(list, context_);
    if (kept != nullptr) kept->push_back(list);
}

void SlicedMachine::execute_slice(const CommandList& list, std::size_t first, std::size_t end) {
    using Seconds = std::chrono::duration<double>;
    const auto begin = std::chrono::steady_clock::now();
    const auto at = list.commands.begin();
    const CommandList slice{{at + std::ptrdiff_t(first), at + std::ptrdiff_t(end)}};
    execute_whole(slice);
    const double took = Seconds(std::chrono::steady_clock::now() - begin).count();
    if (took < quick) most_ = std::min(most_ * 2, 1e12);
    if (took > slow) most_ = std::max(most_ / 2, 1.0);
}

void SlicedMachine::execute(const CommandList& list) {
    if (stop) stop();
    std::size_t end = end_of_slice(list, 0);
    if (end == list.commands.size()) return execute_whole(list);
    // A refusal names the command's number in the whole list, and draws nothing.
    validate(list, machine_->profile(), width_, height_, context_);
    execute_slice(list, 0, end);
    while (end < list.commands.size()) {
        if (stop) stop();
        const std::size_t first = std::exchange(end, end_of_slice(list, end));
        execute_slice(list, first, end);
    }
}

}  // namespace gw::python
