#include "hiddensurface/run/compare.h"

#include "hiddensurface/structures/scan_conversion.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

/// The same list, its state with the stencil counting what is written. Not to be used for counts.
CommandList counting(CommandList list) {
    for (Command& command : list.commands) {
        if (auto* set = std::get_if<SetState>(&command))
            set->state.stencil = {.test = true, .zpass = StencilOp::Incr};
        if (auto* clear = std::get_if<Clear>(&command))
            clear->planes = PlaneMask(clear->planes | mask_of(Plane::Stencil));
    }
    return list;
}

void add_machine_counts(const std::vector<PassReport>& passes, Counts& counts) {
    for (const PassReport& pass : passes) {
        counts.fragments += pass.counters.fragments;
        counts.passed += pass.counters.written;
    }
}

}  // namespace

Result run_on(Machine& machine, const Algorithm& algorithm, const Input& input, StepLog& log) {
    Output output = algorithm.run(input, log);
    Result result{.counts = output.counts,
                  .pieces = std::move(output.pieces),
                  .shares = std::move(output.shares)};
    machine.reset_passes();
    machine.execute(output.list);
    add_machine_counts(machine.passes(), result.counts);
    for (const Rgba& color : machine.planes().color) result.ids.push_back(scene::id_of(color));
    for (const Polygon& polygon : input.polygons)
        result.counts.polygons += polygon.visible() ? 1 : 0;
    for (const std::uint32_t id : result.ids) result.counts.pixels += id != 0 ? 1 : 0;
    result.counts.overdraw = result.counts.passed - result.counts.pixels;
    machine.execute(counting(std::move(output.list)));
    result.writes = machine.planes().stencil;
    return result;
}

void compare(Result& result, const std::vector<std::uint32_t>& z_buffer, const Input& input) {
    const Differences differences(input, result.pieces);
    result.difference.assign(result.ids.size(), Difference::None);
    for (std::size_t i = 0; i < result.ids.size(); ++i) {
        const int x = int(i) % input.view.width, y = int(i) / input.view.width;
        result.difference[i] = differences.at(result.ids[i], z_buffer[i], x, y);
        switch (result.difference[i]) {
            case Difference::None: break;
            case Difference::Tie: result.counts.ties += 1; break;
            case Difference::Edge: result.counts.edges += 1; break;
            case Difference::Snap: result.counts.snapped += 1; break;
            case Difference::Wrong: result.counts.wrong += 1; break;
        }
    }
}

std::vector<std::uint8_t> depth_complexity(const Input& input) {
    std::vector<std::uint8_t> count(std::size_t(input.view.width) * std::size_t(input.view.height));
    for (const Polygon& polygon : input.polygons)
        for (const WindowTriangle& t : polygon.triangles)
            for (const Run& run : scan_convert(t.corners, input.subpixel_bits(), input.window()))
                for (int x = run.x0; x < run.x1; ++x) {
                    std::uint8_t& n = count[input.view.index(x, run.y)];
                    n = static_cast<std::uint8_t>(std::min(n + 1, 255));
                }
    return count;
}

}  // namespace gw::hiddensurface
