#include "gw/fast/plan/plan.h"

#include "gw/base/parallel.h"
#include "gw/stages/fog.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace gw::fast {

bool is_barrier(const Command& command, const std::vector<PassReport>& passes) {
    if (std::holds_alternative<Copy>(command) || std::holds_alternative<CopyTexture>(command))
        return true;
    return std::holds_alternative<BeginPass>(command) && !passes.empty() &&
           passes.back().digested != 0;
}

namespace {

/// Adds a command at a time to a segment.
struct Planner {
    MachineState& machine;
    const Profile& profile;
    const TileGrid& grid;
    Segment segment;
    std::vector<std::function<void()>> geometry_jobs{}, vertex_jobs{};

    Resolved resolved() const { return resolve(machine.state, profile, grid.width, grid.height); }
    PassReport& pass() {
        if (machine.passes.empty()) machine.passes.emplace_back();
        return machine.passes.back();
    }
    void push(auto op) {
        pass();
        segment.ops.push_back({std::move(op), machine.passes.size() - 1});
    }

    /// Work to do later, with the state as it is now.
    auto job(const Draw& draw, auto run) {
        return [state = machine.state, &draw, run] { run(state, draw); };
    }

    GeometrySet& geometry(const Draw& draw) {
        const GeometryKey key = geometry_key(machine.state, draw);
        const auto found = std::find_if(segment.sets.begin(), segment.sets.end(),
                                        [&](const GeometrySet& s) { return s.key == key; });
        if (found != segment.sets.end()) return *found;
        GeometrySet& set = segment.sets.emplace_back();
        set.key = key;
        geometry_jobs.push_back(job(draw, [this, &set](const State& s, const Draw& d) {
            make_geometry(set, s, d, profile, grid.width, grid.height);
            make_bins(set, profile, grid);
        }));
        return set;
    }

    /// A new element, in the memory of an old one where there is any.
    template <typename T>
    static T& next(std::deque<T>& all, std::deque<T>& old) {
        if (old.empty()) return all.emplace_back();
        all.push_back(std::move(old.front()));
        old.pop_front();
        return all.back();
    }

    /// The one of `all` that has this key; else a new one, which `make` will fill.
    template <typename Shared, typename Key, typename Make>
    const Shared* shared(std::deque<Shared>& all, std::deque<Shared>& old, GeometrySet& set,
                         const Draw& draw, const Key& key, const Make& make) {
        set.lists_used = true;
        for (const Shared& s : all)
            if (s.key == key) return &s;
        Shared& out = next(all, old);
        out.key = key;
        vertex_jobs.push_back(job(
            draw, [this, &out, make](const State& s, const Draw& d) { make(out, s, d, profile); }));
        return &out;
    }
    const VertexColors* colors(GeometrySet& set, const Draw& draw) {
        return shared(segment.colors, machine.recycled.colors, set, draw,
                      color_key(set, machine.state, draw), shade_vertices);
    }
    const VertexFog* fog(GeometrySet& set, const Draw& draw) {
        return shared(segment.fogs, machine.recycled.fogs, set, draw, fog_key(set, machine.state),
                      fog_vertices);
    }
    const VertexTexcoords* texcoords(GeometrySet& set, const Draw& draw) {
        return shared(segment.texcoords, machine.recycled.texcoords, set, draw,
                      texcoord_key(set, machine.state), texture_vertices);
    }

    /// Makes what draws share: geometry first, then the values at its vertices.
    void run_jobs(int threads) {
        machine.geometry.give(segment.sets);
        for (const auto* jobs : {&geometry_jobs, &vertex_jobs})
            parallel_for(jobs->size(), threads, [&](std::size_t i, int) { (*jobs)[i](); });
        for (const TileOp& op : segment.ops)
            if (const DrawOp* draw = std::get_if<DrawOp>(&op.op))
                machine.passes[op.pass].counters += draw->set->counters;
    }

    FastTexels* texels(const TextureBinding& binding) {
        if (binding.slot) return &machine.slots.at(*binding.slot);
        auto& entry = machine.texels[binding.texture];
        if (!entry)
            entry = std::make_unique<FastTexels>(
                make_fast_texels(make_texels(*binding.texture, profile.color_bits)));
        return entry.get();
    }

    void add(const Draw& draw) {
        GeometrySet& set = geometry(draw);
        set.jitter.include(machine.state.jitter);

        DrawOp op{&draw, resolved(), &set};
        op.bytes = fragment_bytes(op.state, profile);
        op.needs_color = op.state.writes_color || op.state.state.alpha.func != AlphaFunc::Always;
        op.perspective_color =
            profile.perspective_color && machine.state.shade_model == ShadeModel::Smooth;
        const bool exact_id = machine.state.color_source == ColorSource::PolygonId;
        op.texels_counted = draw.map.enabled() && !exact_id;
        if (op.texels_counted && op.needs_color) {
            FastTexels* found = texels(draw.map);
            const TextureState& t = machine.state.texture;
            op.texels = found;
            if (!textures_by_pixel(t) && (is_linear(t, false) || is_linear(t, true)))
                op.pairs = texel_pairs(*found, t.wrap_s, t.wrap_t);
            op.texcoords = texcoords(set, draw);
        }
        if (op.needs_color && !exact_id) op.colors = colors(set, draw);
        if (op.colors && machine.state.fog.enable) op.fog = fog(set, draw);
        if (machine.state.fog.enable && op.state.fragment_fog) {
            segment.fog_tables.push_back(fog_table(machine.state.fog, profile.color_bits));
            op.fog_table = &segment.fog_tables.back();
        }
        push(std::move(op));
    }
    void add(const Clear& clear) {
        segment.uses_accum = segment.uses_accum || (clear.planes & mask_of(Plane::Accum)) != 0;
        push(ClearOp{&clear, resolved()});
    }
    void add(const WriteSpans& write) {
        SpansOp op{&write, resolved(), {}};
        op.bytes = fragment_bytes(op.state, profile);
        push(std::move(op));
    }
    void add(const WritePixels& write) {
        PixelsOp op{&write, resolved(), {}};
        op.bytes = fragment_bytes(op.state, profile);
        push(std::move(op));
    }
    void add(const Accumulate& accumulate) {
        segment.uses_accum = true;
        push(AccumulateOp{&accumulate, resolved()});
    }
    void add(const Read& read) {
        segment.uses_accum = segment.uses_accum || read.plane == Plane::Accum;
        if (const auto target = machine.targets.find(read.key); target != machine.targets.end())
            return push(ReadOp{.read = &read, .values = target->second.data()});
        Readback& out = machine.readbacks[read.key];
        out.plane = read.plane;
        out.rect = read.rect;
        const std::size_t size = read.rect.area();
        const bool color = read.plane == Plane::Color && !read.packed,
                   accum = read.plane == Plane::Accum;
        out.color.resize(color ? size : 0);
        out.accum.resize(accum ? size : 0);
        out.values.resize(color || accum ? 0 : size);
        push(ReadOp{&read, out.color.data(), out.values.data(), out.accum.data()});
    }
    void add(const SetState& set) { machine.state = set.state; }
    void add(const BeginPass& begin) {
        machine.passes.push_back({begin.name, {}, begin.digests, {}});
    }
    void add(const Copy&) {}
    void add(const CopyTexture&) {}
};

/// Whether planning this read now would let two reads of one segment write the same readback.
bool reads_again(const Command& command, const Segment& segment) {
    const Read* read = std::get_if<Read>(&command);
    if (!read) return false;
    return std::any_of(segment.ops.begin(), segment.ops.end(), [&](const TileOp& op) {
        const ReadOp* other = std::get_if<ReadOp>(&op.op);
        return other && other->read->key == read->key;
    });
}

}  // namespace

Segment plan_segment(std::span<const Command> commands, MachineState& machine,
                     const Profile& profile, const TileGrid& grid, int threads,
                     std::size_t& consumed) {
    Planner planner{machine, profile, grid, {}};
    for (consumed = 0; consumed < commands.size(); ++consumed) {
        const Command& command = commands[consumed];
        if (is_barrier(command, machine.passes) || reads_again(command, planner.segment)) break;
        std::visit([&](const auto& c) { planner.add(c); }, command);
    }
    planner.run_jobs(threads);
    share_visibility(planner.segment);
    return std::move(planner.segment);
}

void retire(Segment segment, MachineState& machine) {
    const auto clear = [](auto& all) {
        for (auto& element : all) element.clear();
    };
    machine.geometry.keep(std::exchange(segment.sets, {}));
    clear(segment.colors);
    clear(segment.fogs);
    clear(segment.texcoords);
    segment.ops.clear();
    segment.fog_tables.clear();
    machine.recycled = std::move(segment);
}

}  // namespace gw::fast
