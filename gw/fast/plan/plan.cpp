#include "gw/fast/plan/plan.h"

#include "gw/base/parallel.h"
#include "gw/base/prefetch.h"
#include "gw/stages/fog.h"
#include "gw/stages/raster/points.h"
#include "gw/stages/raster/samples.h"
#include "gw/stages/tables.h"
#include "gw/stages/texgen.h"

#include <algorithm>
#include <array>

namespace gw::fast {
namespace {

/// The groups of blocks of a window.
std::size_t group_count(const Rect& window) {
    const auto groups = [](int pixels) {
        return std::size_t(pixels + group_side - 1) / std::size_t(group_side);
    };
    return groups(window.width) * groups(window.height);
}

/// The values of one kind that a segment's draws share. Each object has room for every part of a set.
template <class T>
struct SharedValues {
    struct Made {
        T* values;
        std::size_t before;  ///< the one before of the same set: its number, or none
    };
    static constexpr std::size_t none = ~std::size_t{0};

    Pool<T>& pool;
    std::vector<Made> made{};
    std::vector<std::size_t> last{};  ///< by set: the number of the one made last

    T* make(const GroupDraws& group) {
        T& out = pool.next();
        out.inputs.begin(group);
        std::size_t& newest = last[group.group.set_number];
        made.push_back({&out, newest});
        newest = made.size() - 1;
        return &out;
    }
    /// Of the set's last ones: that with the group's values, or the oldest with room, to which the
    /// group is added.
    T* find_or_make(const GroupDraws& group, const SameValues& same) {
        constexpr int most_tried = 8;
        T* out = nullptr;
        std::size_t at = last[group.group.set_number];
        for (int i = 0; i < most_tried && at != none; ++i, at = made[at].before) {
            T* const tried = made[at].values;
            if (tried->inputs.has_values_of(group, same)) return tried;
            if (tried->inputs.has_room_for(group)) out = tried;
        }
        if (!out) out = make(group);
        out->inputs.add(group, same);
        return out;
    }
};

/// The texels of a fragment, of all units.
int look_ups_of(const Draw& draw, const State& state) {
    int sum = 0;
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        const TextureBinding& map = map_of(draw, unit);
        if (map.enabled())
            sum += look_ups(texture_of(state, unit).min_filter,
                            map.texture ? map.texture->dimensions : 2);
    }
    return sum;
}
/// Whether others than unit 0 are on.
bool has_more(const Draw& draw) {
    return draw.more_maps && std::ranges::any_of(*draw.more_maps, &TextureBinding::enabled);
}

/// Makes the operations of a scanned segment.
struct Planner {
    MachineState& machine;
    const Profile& profile;
    const Surface& surface;
    Segment& segment = machine.segment;
    SharedValues<VertexColors> colors{segment.colors};
    SharedValues<VertexFog> fogs{segment.fogs};
    SharedValues<VertexTexcoords> texcoords{segment.texcoords};
    const Texture* last_texture = nullptr;
    FastTexels* last_texels = nullptr;

    /// `compared`: only its depths are wanted.
    FastTexels* texels(const TextureBinding& binding, bool compared = false) {
        if (binding.slot) return &machine.slots.at(*binding.slot);
        if (binding.surface) return &machine.surface_texels(*binding.surface, compared);
        if (binding.texture.get() != last_texture) {
            last_texture = binding.texture.get();
            last_texels = &machine.texels.find_or_make(binding.texture, machine.profile);
        }
        return last_texels;
    }
    /// Null if texels are looked up pixel by pixel, or no filter is linear.
    const TexelPairs* pairs_of(FastTexels& of, const TextureState& t, bool projective,
                               const ResolvedTexture& resolved) const {
        if (projective || has_rare_lookup(t, of.texels)) return nullptr;
        if (!is_linear(t, false) && !is_linear(t, true)) return nullptr;
        return texel_pairs(of, addressing(t, of.texels, resolved.border_color));
    }
    /// Of all units, if others than the first are on.
    void bind_units(DrawOp& op, const Draw& draw, GroupDraws in) {
        UnitOps& units = segment.unit_ops.emplace_back();
        for (in.unit = max_texture_units; in.unit-- > 0;) {
            const TextureBinding& map = map_of(draw, in.unit);
            if (!map.enabled()) continue;
            const TextureState& t = texture_of(*in.state, in.unit);
            FastTexels* const found = texels(map, t.shadow_compare);
            const bool projective = divides_by_q(t, draw, in.unit);
            units[in.unit] = {found, texcoords.find_or_make(in, same_texcoords), projective,
                              pairs_of(*found, t, projective, op.state.texture(in.unit))};
            op.texels = units[in.unit].texels;
            op.texcoords = units[in.unit].texcoords;
            op.projective = units[in.unit].projective;
        }
        op.units = &units;
    }
    void bind_texture(DrawOp& op, const Draw& draw, const GroupDraws& in) {
        const TextureState& t = in.state->texture;
        FastTexels* const found = texels(draw.map, t.shadow_compare);
        op.texels = found;
        op.projective = divides_by_q(t, draw);
        op.pairs = pairs_of(*found, t, op.projective, op.state);
        op.texcoords = texcoords.find_or_make(in, same_texcoords);
    }
    const std::vector<std::uint32_t>* table_of(ScannedState& state) {
        if (!state.fog_table) {
            FogState fog = state.state->fog;
            fog.color = {};
            std::deque<FogTable>& all = segment.fog_tables;
            if (all.empty() || all.back().of != fog)
                all.push_back({fog, gw::fog_table(fog, profile.color_bits)});
            state.fog_table = &all.back().values;
        }
        return state.fog_table;
    }

    void include_jitter(GeometrySet& set, const Resolved& r) const {
        const JitterState& jitter = r.state.jitter;
        set.jitter.include(jitter);
        if (!r.state.multisample.enable) return;
        for (int k = 0; k < r.samples; ++k) {
            const JitterState shift = sample_shift(r.samples, k, profile.subpixel_bits);
            set.jitter.include({jitter.x + shift.x, jitter.y + shift.y});
        }
    }

    /// Adds the draws of one group; `steps` are its draws.
    void add_draws(std::span<const Step> steps) {
        ScannedState& scanned = *steps[0].state;
        const State& state = *scanned.state;
        const Draw& first = std::get<Draw>(*steps[0].command);
        const PartGroup& group = *steps[0].part->group;
        GeometrySet& set = *group.set;
        include_jitter(set, scanned.resolved);
        const Draw* const* draws = segment.draws.data() + segment.draws.size();
        for (const Step& step : steps) segment.draws.push_back(&std::get<Draw>(*step.command));

        DrawOp op{.draws = draws, .state = scanned.resolved, .group = &group, .set = &set};
        op.bytes = scanned.bytes;
        op.needs_color = op.state.writes_color || op.state.state.alpha.func != AlphaFunc::Always;
        op.needs_color |= op.state.state.multisample.alpha_to_coverage;
        op.perspective_color = profile.perspective_color &&
                               state.shade_model == ShadeModel::Smooth &&
                               state.color_source != ColorSource::PolygonId;
        const bool exact_id = state.color_source == ColorSource::PolygonId;
        if (!exact_id) op.look_ups = look_ups_of(first, state);
        const GroupDraws inputs{group, &state, draws};
        if (op.look_ups > 0 && op.needs_color)
            has_more(first) ? bind_units(op, first, inputs) : bind_texture(op, first, inputs);
        if (op.needs_color && !exact_id) op.colors = colors.find_or_make(inputs, same_colors);
        if (op.colors && state.fog.enable) op.fog = fogs.find_or_make(inputs, same_fog);
        if (state.fog.enable && op.state.fragment_fog) op.fog_table = table_of(scanned);
        op.sums_colors = op.colors && sums_colors(state);
        op.direct_fog = op.fog && fog_is_direct(state.fog, op.state.fragment_fog);
        set.lists_used = set.lists_used || op.texcoords || op.colors || op.fog;
        segment.ops.push_back({op, steps[0].pass});
    }

    void add(const Clear& clear, const Step& step) {
        const PlaneMask planes = clear.planes & surface.planes;
        segment.uses_accum = segment.uses_accum || (planes & mask_of(Plane::Accum)) != 0;
        segment.ops.push_back({ClearOp{&clear, planes, step.state->resolved}, step.pass});
    }
    void add(const WriteSpans& write, const Step& step) {
        segment.ops.push_back(
            {SpansOp{&write, step.state->resolved, step.state->bytes}, step.pass});
    }
    void add(const WritePixels& write, const Step& step) {
        segment.ops.push_back(
            {PixelsOp{&write, step.state->resolved, step.state->bytes}, step.pass});
    }
    void add(const DrawPixels& draw, const Step& step) {
        const Resolved& state = step.state->resolved;
        BoundTexels used{};
        for (std::size_t unit = 0; unit < used.size(); ++unit)
            if (map_of(draw, unit).enabled()) used[unit] = &texels(map_of(draw, unit))->texels;
        const PlacedPixels& placed = segment.placed_pixels.emplace_back(draw, state, used);
        segment.ops.push_back({DrawPixelsOp{&placed, state, step.state->bytes}, step.pass});
    }
    void add(const Accumulate& accumulate, const Step& step) {
        segment.uses_accum = true;
        segment.ops.push_back({AccumulateOp{&accumulate, step.state->resolved}, step.pass});
    }
    void add(const Read& read, const Step& step) {
        segment.uses_accum = segment.uses_accum || read.plane == Plane::Accum;
        segment.ops.push_back({target_of(read), step.pass});
    }
    ReadOp target_of(const Read& read) {
        if (const auto target = machine.targets.find(read.key); target != machine.targets.end()) {
            const ReadLayout& layout = target->second.layout;
            if (layout.known) layout.known->parts.resize(group_count(read.rect));
            return {.read = &read, .values = target->second.values.data(), .layout = layout};
        }
        Readback& out = machine.readbacks[read.key];
        out.plane = read.plane;
        out.rect = read.rect;
        const std::size_t size = read.rect.area();
        const bool color = read.plane == Plane::Color && !read.packed,
                   accum = read.plane == Plane::Accum;
        out.color.resize(color ? size : 0);
        out.accum.resize(accum ? size : 0);
        out.values.resize(color || accum ? 0 : size);
        return {&read, out.color.data(), out.values.data(), out.accum.data()};
    }
    void add(const auto&, const Step&) {}

    void add_steps() {
        const std::span<const Step> steps = segment.scan.steps();
        segment.draws.reserve(steps.size());  // their addresses are kept
        const std::size_t sets = segment.scan.sets().size();
        colors.last.assign(sets, colors.none);
        fogs.last.assign(sets, fogs.none);
        texcoords.last.assign(sets, texcoords.none);
        for (std::size_t i = 0; i < steps.size();) {
            if (i + 4 < steps.size()) prefetch(steps[i + 4].command, sizeof(Draw));
            segment.uses_both_colors =
                segment.uses_both_colors || draws_to_both(steps[i].state->resolved.state);
            if (steps[i].part) {
                const std::size_t count = steps[i].part->group->parts;
                add_draws(steps.subspan(i, count));
                i += count;
            } else {
                std::visit([&](const auto& c) { add(c, steps[i]); }, *steps[i].command);
                i += 1;
            }
        }
    }

    /// Makes the data that draws share: geometry first, then the values at its vertices.
    void make_shared(const TileGrid& grid, int threads) {
        const std::span<GeometrySet* const> sets = segment.scan.sets();
        segment.scratch.resize(std::size_t(threads));
        parallel_for(sets.size(), threads, [&](std::size_t i, int worker) {
            GeometryScratch& scratch = segment.scratch[std::size_t(worker)];
            make_geometry(*sets[i], profile, scratch);
            make_bins(*sets[i], profile, grid, scratch);
        });
        const std::size_t colors_end = colors.made.size(), fog_end = colors_end + fogs.made.size();
        parallel_for(fog_end + texcoords.made.size(), threads, [&](std::size_t i, int) {
            if (i < colors_end)
                shade_vertices(*colors.made[i].values, profile);
            else if (i < fog_end)
                fog_vertices(*fogs.made[i - colors_end].values, profile);
            else
                texture_vertices(*texcoords.made[i - fog_end].values, profile);
        });
        segment.scan.finish_groups();
        for (TileOp& op : segment.ops)
            if (DrawOp* const draw = std::get_if<DrawOp>(&op.op)) finish(*draw, op.pass);
    }
    void finish(DrawOp& op, std::size_t pass) {
        op.uniform_color = op.colors && op.colors->is_uniform(*op.group);
        op.perspective_color &= !op.uniform_color;
        op.wide_texcoords = op.texcoords && op.texcoords->are_wide && !op.projective;
        // Borders in more than 8 bits have no pairs.
        const TextureState& texture = op.state.state.texture;
        op.by_pixel =
            op.texels &&
            (op.units || op.projective || op.wide_texcoords || is_sprite(op.state.state, 0) ||
             has_rare_lookup(texture, op.texels->texels) || (!op.pairs && reaches_border(texture)));
        machine.passes[pass].counters += op.group->counters();
    }
};

}  // namespace

std::size_t plan_segment(std::span<const Command> commands, MachineState& machine,
                         const Profile& profile, const SegmentTarget& target, int threads) {
    const TileGrid& grid = target.grid;
    Segment& segment = machine.segment;
    const std::size_t consumed =
        segment.scan.run(commands, machine.state, machine.passes, profile, target.surface);
    if (segment.scan.steps().empty()) return consumed;
    segment.scan.form_sets(machine.geometry);
    Planner planner{machine, profile, target.surface};
    planner.add_steps();
    planner.make_shared(grid, threads);
    if (target.surface.samples == 0) share_visibility(segment);
    list_by_tile(segment, grid);
    return consumed;
}

void end_segment(MachineState& machine) {
    Segment& segment = machine.segment;
    if (segment.scan.steps().empty()) return;
    if (!segment.scan.sets().empty()) machine.geometry.end_segment();
    machine.texels.end_segment();
    segment.colors.release();
    segment.fogs.release();
    segment.texcoords.release();
    const auto clear = [](auto& all) {
        if (all.capacity() > 8 * all.size() + 4096) all = std::decay_t<decltype(all)>();
        all.clear();
    };
    clear(segment.ops);
    clear(segment.draws);
    clear(segment.count_slots);
    clear(segment.tiles);
    clear(segment.tile_start);
    clear(segment.tile_ops);
    segment.fog_tables.clear();
    segment.placed_pixels.clear();
    segment.unit_ops.clear();
    for (GeometryScratch& scratch : segment.scratch) scratch.trim();
    segment.uses_accum = false;
    segment.uses_both_colors = false;
    segment.visible_records = 0;
}

}  // namespace gw::fast
