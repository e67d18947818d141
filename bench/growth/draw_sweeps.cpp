#include "bench/draws/field.h"
#include "bench/growth/sweep.h"
#include "gw/machine.h"

#include <fmt/format.h>

#include <cmath>

namespace gw::growth {
namespace {

using draws::Own;

/// Executes lists in turn.
class Lists {
public:
    /// `make(shift)` gives the lists of a frame; another shift gives other vertices.
    using Make = std::function<std::vector<CommandList>(double shift)>;
    Lists(Make make, bool again, int width, int height)
        : make_(std::move(make)),
          again_(again),
          machine_(make_fast(vgx(), width, height, {.threads = 1})) {}

    void set_up() {
        if (again_ && !lists_.empty()) return;
        shift_ += 1e-3 / 64;
        lists_ = make_(shift_);
    }
    void run() {
        for (const CommandList& list : lists_) machine_->execute(list);
        machine_->reset_passes();
    }

private:
    Make make_;
    bool again_;
    double shift_ = 0;
    std::unique_ptr<Machine> machine_;
    std::vector<CommandList> lists_;
};

Step step(double amount, Lists::Make make, bool again, int width = draws::width,
          int height = draws::height) {
    return {amount, [=](int repeats) {
                Lists lists(make, again, width, height);
                return least_time(
                    repeats, [&] { lists.run(); }, [&] { lists.set_up(); });
            }};
}

const std::vector<int> draw_counts{100, 316, 1000, 3162, 10000, 31623, 100000};

Sweep draws_of(const char* name, Own own, bool again) {
    Sweep sweep{name, name, {}};
    for (const int n : draw_counts)
        sweep.steps.push_back(step(
            n, [n, own](double shift) { return std::vector{draws::Ours(n).draws(own, shift)}; },
            again));
    return sweep;
}

/// The commands of a field without its clear, under another state.
void add_pass(CommandList& list, const CommandList& field,
              const std::function<void(State&)>& change, const LightsRef& lights = nullptr) {
    for (Command command : field.commands) {
        if (std::holds_alternative<Clear>(command)) continue;
        if (SetState* set = std::get_if<SetState>(&command)) change(set->state.edit());
        if (Draw* draw = std::get_if<Draw>(&command); draw && lights) draw->lights = lights;
        list.add(std::move(command));
    }
}
void add_equal_passes(CommandList& list, const CommandList& field, int passes,
                      const std::vector<LightsRef>& lights = {}) {
    for (int i = 0; i < passes; ++i)
        add_pass(
            list, field,
            [](State& s) {
                s.depth = {true, DepthFunc::Equal, false};
                s.blend = {true, BlendFactor::One, BlendFactor::One};
            },
            lights.empty() ? nullptr : lights[std::size_t(i)]);
}

/// A depth pass and 16 passes under Equal.
Sweep passes_by_draws() {
    Sweep sweep{"parts-in-17-passes", "parts-in-17-passes", {}};
    for (const int n : {50, 158, 500, 1581, 5000})
        sweep.steps.push_back(step(
            n,
            [n](double shift) {
                CommandList list = draws::Ours(n).draws(Own::Material, shift);
                add_equal_passes(list, CommandList(list), 16);
                return std::vector{list};
            },
            false));
    return sweep;
}

/// A pass for each light over 1,000 parts.
Sweep lights_by_draws() {
    Sweep sweep{"lights-over-1000-parts", "lights-over-1000-parts", {}};
    for (const int n : {1, 2, 4, 8, 16, 32, 64})
        sweep.steps.push_back(step(
            n,
            [n](double shift) {
                CommandList list = draws::Ours(1000).draws(Own::Material, shift);
                std::vector<LightsRef> lights;
                for (int i = 0; i < n; ++i) {
                    Light light = draws::lamp();
                    light.position.x = float(i) / 8 - 4;
                    lights.push_back(
                        std::make_shared<const std::vector<Light>>(std::vector<Light>{light}));
                }
                add_equal_passes(list, CommandList(list), n, lights);
                return std::vector{list};
            },
            false));
    return sweep;
}

/// Lists of three draws, in turn.
Sweep lists(const char* name, int width, int height) {
    Sweep sweep{name, name, {}};
    for (const int n : {10, 100, 1000, 10000})
        sweep.steps.push_back(step(
            n,
            [n](double shift) {
                const CommandList three = draws::Ours(3).draws(Own::Nothing, shift);
                CommandList without_clear;
                add_pass(without_clear, three, [](State&) {});
                std::vector<CommandList> out(std::size_t(n), without_clear);
                out.front() = three;
                return out;
            },
            false, width, height));
    return sweep;
}

/// Triangles of a mesh, 1,000 meshes.
Sweep mesh_sizes() {
    Sweep sweep{"triangles-of-a-small-mesh", "triangles-of-a-small-mesh", {}};
    for (const int n : {2, 6, 20, 60, 200})
        sweep.steps.push_back(step(
            n,
            [n](double shift) {
                CommandList list = draws::Ours(1).draws(Own::Nothing, shift);
                const std::vector<draws::Quad> places = draws::quads(1000);
                list.commands.pop_back();
                for (const draws::Quad& q : places) {
                    MeshData data{.primitive = Primitive::TriangleStrip};
                    for (int i = 0; i < n + 2; ++i)
                        data.positions.push_back({q.x + float(shift) + float(i) * 16 / float(n),
                                                  q.y + (i % 2 == 0 ? 0.f : 16.f), q.z});
                    list.add(Draw{.mesh = make_mesh(std::move(data))});
                }
                return std::vector{list};
            },
            false));
    return sweep;
}

}  // namespace

std::vector<Sweep> draw_sweeps() {
    return {draws_of("draws", Own::Nothing, false),
            draws_of("draws-again", Own::Nothing, true),
            draws_of("matrices", Own::Matrix, false),
            draws_of("materials", Own::Material, false),
            draws_of("states", Own::State, false),
            draws_of("textures-in-turn", Own::Texture, false),
            passes_by_draws(),
            lights_by_draws(),
            mesh_sizes(),
            lists("lists", draws::width, draws::height),
            lists("lists-in-a-tiny-window", 16, 16)};
}

}  // namespace gw::growth
