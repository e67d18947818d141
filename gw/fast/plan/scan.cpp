#include "gw/fast/plan/scan.h"

#include "gw/base/prefetch.h"
#include "gw/stages/texgen.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace gw::fast {
namespace {

/// The limits of one set, so that sets can be made in parallel and a moving part does not force
/// many others to be made again.
constexpr std::size_t most_parts = 1024, most_vertices = 4096;
constexpr std::size_t most_triangles_of_small = 256;
/// A segment that has many parts ends at so many vertices, so that its memory is bounded.
constexpr std::size_t many_parts = 1024, most_segment_vertices = std::size_t{1} << 22;

bool is_small_mesh(const Mesh& mesh, const GeometryState& state) {
    return mesh.kind() == MeshKind::Triangles && state.polygon_mode == PolygonMode::Fill &&
           state.back_polygon_mode == PolygonMode::Fill &&
           mesh.triangles().size() <= most_triangles_of_small &&
           mesh.vertex_count() <= 2 * most_triangles_of_small;
}

template <class... Values>
void add_numbers(Hash& hash, Values... values) {
    const std::array<double, sizeof...(values)> all{double(values)...};
    hash.add_all(all.data(), all.size());
}

std::uint64_t hash_of(const GeometryState& s) {
    Hash hash;
    hash.add_all(&s.projection[0][0], 16);
    add_numbers(hash, s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height,
                s.cull.enable, s.cull.face, s.cull.front, s.polygon_mode, s.back_polygon_mode,
                s.stipple_period, s.keeps_slopes[0], s.keeps_slopes[1], s.point_margin,
                s.line_margin, s.fill_margin, s.line_smooth, s.clip_control.origin,
                s.clip_control.depth);
    hash.add(s.depth_range.near_value).add(s.depth_range.far_value);
    for (const ClipPlane& plane : s.clip_planes)
        if (plane.enable) hash.add_all(&plane.plane.x, 4);
    return hash.value();
}

/// Hashes the fields in which states of one list usually differ.
std::uint64_t hash_of(const State& s) {
    Hash hash;
    hash.add_all(&s.projection[0][0], 16);
    add_numbers(hash, s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height,
                s.scissor.test, s.scissor.box.x, s.scissor.box.y, s.scissor.box.width, s.jitter.x,
                s.jitter.y, s.cull.enable, s.cull.face, s.shade_model, s.color_source, s.depth.test,
                s.depth.func, s.depth.mask);
    add_numbers(hash, s.draw_buffer, s.blend.enable, s.blend.src, s.blend.dst, s.stencil.test,
                s.stencil.func, s.stencil.ref, s.stencil.mask, s.stencil.zfail, s.stencil.zpass,
                s.stencil.write_mask, s.alpha.test, s.alpha.func, s.fog.enable, s.fog.mode,
                s.texture.env, s.texture.gen, s.texture.min_filter, s.texture.wrap_s);
    add_numbers(hash, s.alpha.ref, s.fog.density, s.fog.start, s.fog.end, s.fog.color.x,
                s.fog.color.y, s.fog.color.z, s.texture.env_color.x, s.texture.env_color.y,
                s.texture.env_color.z, s.texture.env_color.w, s.lighting.model_ambient.x,
                s.depth_range.near_value, s.polygon_offset.units, s.polygon_offset.factor,
                s.line_width, s.point_size, s.blend.color.x, s.texture.lod.bias);
    return hash.add_all(&s.texture.matrix[0][0], 16).value();
}

/// Of the part of a draw with this hash.
std::uint64_t part_hash(std::uint64_t draw_hash, const ScannedState& state) {
    return Hash().add(draw_hash).add(state.geometry_hash).value();
}

/// Whether two draws look up one texture in one way.
bool same_map(const Draw& a, const Draw& b, const State& state) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        if (unit > 0 && !a.more_maps && !b.more_maps) break;
        const TextureBinding &m = map_of(a, unit), &n = map_of(b, unit);
        if (m != n) return false;
        const TextureState& own = texture_of(state, unit);
        if (m.enabled() && divides_by_q(own, a, unit) != divides_by_q(own, b, unit)) return false;
    }
    return true;
}

std::optional<Plane> plane_of(DrawBuffer buffer) {
    switch (buffer) {
        case DrawBuffer::Front: return Plane::Color;
        case DrawBuffer::Back: return Plane::Back;
        case DrawBuffer::None:
        case DrawBuffer::FrontAndBack: break;
    }
    return {};
}
Plane plane_of(ReadBuffer buffer) {
    return buffer == ReadBuffer::Front ? Plane::Color : Plane::Back;
}

/// The one colour plane that a command reads or writes.
struct ColorPlaneOf {
    const State& state;

    std::optional<Plane> operator()(const Read& c) const {
        if (c.plane != Plane::Color) return {};
        return plane_of(state.read_buffer);
    }
    std::optional<Plane> operator()(const Accumulate& c) const {
        if (c.op == AccumOp::Return) return plane_of(state.draw_buffer);
        return plane_of(state.read_buffer);
    }
    std::optional<Plane> operator()(const auto&) const { return plane_of(state.draw_buffer); }
};

template <class T>
void clear_and_trim(std::vector<T>& all) {
    if (all.capacity() > 8 * all.size() + 4096) all = std::vector<T>();
    all.clear();
}

}  // namespace

bool is_barrier(const Command& command, const std::vector<PassReport>& passes) {
    if (std::holds_alternative<Copy>(command) || std::holds_alternative<CopyTexture>(command) ||
        std::holds_alternative<SwapBuffers>(command) || std::holds_alternative<Query>(command) ||
        std::holds_alternative<MakeSurface>(command) ||
        std::holds_alternative<UseSurface>(command) || std::holds_alternative<Blit>(command))
        return true;
    if (const auto* draw = std::get_if<DrawPixels>(&command)) return draw->source.has_value();
    return std::holds_alternative<BeginPass>(command) && !passes.empty() &&
           passes.back().digested != 0;
}

/// Whether the command can run while the segment's colour plane is in use.
bool Scan::fits_color_plane(const Command& command, const State& state) {
    const std::optional<Plane> plane = std::visit(ColorPlaneOf{state}, command);
    if (plane && !color_plane_) color_plane_ = plane;
    return !plane || plane == color_plane_;
}

void Scan::clear() {
    geometries_.clear();
    geometry_table_.clear();
    states_.clear();
    state_table_.clear();
    parts_.clear();
    part_table_.clear();
    vertices_ = 0;
    clear_and_trim(steps_);
    clear_and_trim(sets_);
    clear_and_trim(groups_);
    read_keys_.clear();
    color_plane_.reset();
    given_ = nullptr;
    state_ = state_before_ = nullptr;
    hashed_ = nullptr;
}

void Scan::use_state(const State& state) {
    if (given_ == &state) return;
    given_ = &state;
    if (state_before_ && state_before_->state == &state) return std::swap(state_, state_before_);
    if (state_ && *state_->state == state) return;
    state_before_ = state_;
    const std::uint64_t hash = hash_of(state);
    state_ = state_table_.find(hash, [&](const ScannedState& s) { return *s.state == state; });
    if (state_) return;
    Resolved resolved = resolve(state, *profile_, surface_);
    const FragmentBytes bytes = fragment_bytes(resolved, *profile_);
    const GeometryState geometry = geometry_state(resolved.state, profile_->subpixel_bits);
    const std::uint64_t geometry_hash = hash_of(geometry);
    state_ = &states_.emplace_back(ScannedState{&state, std::move(resolved), bytes,
                                                share(geometry, geometry_hash), geometry_hash});
    state_table_.add(hash, state_);
}

const GeometryState* Scan::share(const GeometryState& geometry, std::uint64_t hash) {
    if (const GeometryState* const found =
            geometry_table_.find(hash, [&](const GeometryState& g) { return g == geometry; }))
        return found;
    const GeometryState* const made = &geometries_.emplace_back(geometry);
    geometry_table_.add(hash, made);
    return made;
}

std::uint64_t Scan::hash_of_transform(const dmat4& transform) {
    if (!hashed_ || std::memcmp(hashed_, &transform, sizeof(dmat4)) != 0) {
        hashed_ = &transform;
        transform_hash_ = Hash().add_all(&transform[0][0], 16).value();
    }
    return transform_hash_;
}

/// Hashes the draw of a command and prefetches all that add_draw() reads of it.
void Scan::look_ahead(std::span<const Command> commands, std::size_t i) {
    prefetch_ahead(commands, i, steps_ahead, sizeof(Draw));
    if (i >= commands.size()) return;
    const Draw* const draw = std::get_if<Draw>(&commands[i]);
    if (!draw) return;
    prefetch(draw->mesh.get(), 3 * cache_line);
    hashes_[i % steps_ahead] =
        Hash().add(draw->mesh.get()).add(hash_of_transform(draw->eye_from_object)).value();
    if (state_) part_table_.prefetch_slot(part_hash(hashes_[i % steps_ahead], *state_));
}

ScannedPart& Scan::part_of(const Draw& draw, std::uint64_t draw_hash) {
    const std::uint64_t hash = part_hash(draw_hash, *state_);
    ScannedPart* const found = part_table_.find(hash, [&](const ScannedPart& p) {
        return p.draw->mesh == draw.mesh && p.draw->eye_from_object == draw.eye_from_object &&
               p.state->geometry == state_->geometry;
    });
    if (found) return *found;
    ScannedPart& part = parts_.emplace_back(ScannedPart{
        &draw, state_, hash, std::uint32_t(parts_.size()), draw.mesh->vertex_count(),
        is_small_mesh(*draw.mesh, *state_->geometry), !parts_.empty() && parts_.back().ends_group});
    part_table_.add(hash, &part);
    vertices_ += part.vertices;
    return part;
}

bool Scan::is_full() const {
    return parts_.size() >= many_parts && vertices_ >= most_segment_vertices;
}

void Scan::end_run() {
    if (steps_.empty() || !steps_.back().part) return;
    ScannedPart& last = *steps_.back().part;
    last.ends_group = true;
    if (last.index + 1 < parts_.size()) parts_[last.index + 1].begins_group = true;
}

void Scan::add_step(const Command& command, ScannedPart* part) {
    if (passes_->empty()) passes_->emplace_back();
    steps_.push_back({&command, state_, passes_->size() - 1, part});
}

void Scan::add_draw(const Command& command, const Draw& draw, std::uint64_t draw_hash) {
    ScannedPart& part = part_of(draw, draw_hash);
    const Step* const last = steps_.empty() || !steps_.back().part ? nullptr : &steps_.back();
    const bool continues = last && last->state == state_ && last->pass + 1 == passes_->size() &&
                           part.index == last->part->index + 1 && part.is_small &&
                           last->part->is_small &&
                           same_map(std::get<Draw>(*last->command), draw, *state_->state);
    if (!continues) {
        end_run();
        part.begins_group = true;
    }
    add_step(command, &part);
}

std::size_t Scan::run(std::span<const Command> commands, State& state,
                      std::vector<PassReport>& passes, const Profile& profile,
                      const Surface& surface) {
    clear();
    profile_ = &profile;
    surface_ = surface;
    passes_ = &passes;
    initial_ = state;
    const State* current = &initial_;
    const bool two_colors = profile.color_planes == 2 && surface.is_window();
    std::size_t consumed = 0;
    for (std::size_t i = 0; i < steps_ahead; ++i) look_ahead(commands, i);
    for (; consumed < commands.size(); look_ahead(commands, steps_ahead + consumed++)) {
        const Command& command = commands[consumed];
        if (is_barrier(command, passes)) break;
        if (const Read* read = std::get_if<Read>(&command);
            read && !read_keys_.insert(read->key).second)
            break;
        if (const SetState* set = std::get_if<SetState>(&command)) {
            current = &*set->state;
        } else if (const BeginPass* begin = std::get_if<BeginPass>(&command)) {
            passes.push_back({begin->name, {}, begin->digests, {}, {}});
        } else {
            if (two_colors && !fits_color_plane(command, *current)) break;
            use_state(*current);
            if (const Draw* draw = std::get_if<Draw>(&command)) {
                if (is_full()) break;
                add_draw(command, *draw, hashes_[consumed % steps_ahead]);
            } else {
                end_run();
                add_step(command, nullptr);
            }
        }
    }
    end_run();
    if (current != &initial_) state = *current;
    return consumed;
}

bool Scan::begins_set(const ScannedPart& part, std::size_t parts, std::size_t vertices) const {
    if (part.index == 0 || !part.is_small || parts == most_parts || vertices > most_vertices)
        return true;
    const ScannedPart& before = parts_[part.index - 1];
    return !before.is_small || before.state->geometry != part.state->geometry;
}

void Scan::form_sets(KeptGeometry& kept) {
    struct Wanted {
        std::size_t first, count;
        std::uint64_t hash;
    };
    std::vector<Wanted> wanted;
    std::vector<PartKey> keys;
    std::size_t vertices = 0;
    for (ScannedPart& part : parts_) {
        vertices += part.vertices;
        if (begins_set(part, wanted.empty() ? 0 : wanted.back().count, vertices)) {
            wanted.push_back({part.index, 0, 0});
            part.begins_group = true;
            vertices = part.vertices;
        }
        Wanted& set = wanted.back();
        if (part.begins_group)
            groups_.push_back({.set_number = std::uint32_t(wanted.size() - 1),
                               .first_part = std::uint32_t(set.count)});
        groups_.back().parts += 1;
        set.count += 1;
        set.hash = Hash().add(set.hash).add(part.hash).value();
        keys.push_back({&part.draw->mesh, &part.draw->eye_from_object});
    }
    const auto keys_of = [&](const Wanted& w) {
        return std::span<const PartKey>(keys).subspan(w.first, w.count);
    };
    if (wanted.empty()) return;
    kept.begin_segment();
    for (const Wanted& w : wanted)
        sets_.push_back(kept.find(w.hash, *parts_[w.first].state->geometry, keys_of(w)));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Wanted& w = wanted[i];
        const ScannedState& state = *parts_[w.first].state;
        if (!sets_[i]) sets_[i] = &kept.make(w.hash, *state.geometry, keys_of(w));
        sets_[i]->viewport = state.resolved.viewport;
    }
    auto part = parts_.begin();
    for (PartGroup& group : groups_) {
        group.set = sets_[group.set_number];
        for (std::uint32_t k = 0; k < group.parts; ++k) (part++)->group = &group;
    }
}

void Scan::finish_groups() {
    for (PartGroup& group : groups_) group.finish();
}

}  // namespace gw::fast
