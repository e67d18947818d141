// Finds the runs of vertices in a display list and assembles them.
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/assemble/run_calls.h"
#include "gl/drawable/call_trace.h"
#include "gl/lists/sealed_runs.h"

#include <cmath>
#include <optional>
#include <tuple>

namespace gw::gl {

/// Goes through a list's calls once. A group is a range of complete runs, and of the calls that give
/// values to vertices around them.
class Sealer {
public:
    explicit Sealer(DisplayList& list) : list_(list) {}
    void seal();

private:
    using Position = DisplayList::Position;

    /// Groups of fewer vertices are small.
    static constexpr std::size_t fewest_vertices = 32;
    /// Further ones are always played: a sealed group takes a kilobyte.
    static constexpr int most_small_groups = 64;

    /// The values of the call at this place if it is one of `execute`; else null.
    template <auto execute>
    const typename KeptValues<decltype(execute)>::type* call_of(const Position& p) const {
        if (list_.header(p).operations->id != &call_id<execute>) return nullptr;
        return reinterpret_cast<const typename KeptValues<decltype(execute)>::type*>(
            list_.values(p));
    }

    /// Takes a call into the group; false if it cannot stand there.
    bool take(const Position& p);
    bool take_begin(GLenum mode);
    bool take_vertex(const vec4& position, Function function);
    bool take_end();
    bool take_texcoord(const std::tuple<GLenum, float, float, float, float>& call);
    void begin_group(const Position& p, std::uint32_t first);
    /// Ends the group before `p`: a step of its own if it is complete and large.
    void end_group(const Position& p);
    void add_step(const Position& begin, const Position& end, std::uint32_t first,
                  std::shared_ptr<SealedRuns> runs);

    DisplayList& list_;
    Position group_begin_;
    std::uint32_t group_first_ = 0, number_ = 0;  ///< of the group's first call, of the present one
    RunCalls run_calls_;
    std::shared_ptr<SealedRuns> runs_;
    AssembledVertex now_;
    FurtherTexcoords further_;
    GivenValues given_;
    std::optional<GivenValues> given_to_all_;  ///< at the first vertex
    std::size_t vertices_ = 0;
    int small_groups_ = 0;
    bool inside_ = false;
};

void Sealer::begin_group(const Position& p, std::uint32_t first) {
    group_begin_ = p;
    group_first_ = first;
    runs_ = std::make_shared<SealedRuns>();
    now_ = {};
    further_ = initial_further_texcoords;
    given_ = {};
    given_to_all_.reset();
    vertices_ = 0;
    inside_ = false;
}

bool Sealer::take_begin(GLenum mode) {
    if (inside_ || mode > GL_POLYGON) return false;
    if (mode == GL_LINE_STRIP || mode == GL_LINE_LOOP) runs_->has_line_strips = true;
    auto& parts = runs_->parts;
    if (parts.empty() || !parts.back().assembly.takes(mode, false)) parts.emplace_back();
    parts.back().assembly.begin(mode, false);
    if (calls_are_kept) run_calls_.begin(mode, parts.back().assembly);
    return inside_ = true;
}

bool Sealer::take_vertex(const vec4& position, Function function) {
    if (!inside_) return false;
    if (!given_to_all_) given_to_all_ = given_;
    if (*given_to_all_ != given_) return false;
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(position[i])) return false;
    now_.position = position;
    Assembly& assembly = runs_->parts.back().assembly;
    assembly.add(now_);
    if (given_.further_texcoords != decltype(given_.further_texcoords){})
        assembly.further_texcoords.push_back(further_);
    if (calls_are_kept) run_calls_.add({.number = number_, .function = name_of(function)});
    ++vertices_;
    return true;
}

bool Sealer::take_end() {
    if (!inside_) return false;
    SealedRuns::Part& part = runs_->parts.back();
    part.assembly.end();
    if (calls_are_kept) run_calls_.end(part.assembly, part.calls);
    inside_ = false;
    return true;
}

/// Takes coordinates of any unit that a profile may have.
bool Sealer::take_texcoord(const std::tuple<GLenum, float, float, float, float>& call) {
    const auto& [texture, s, t, r, q] = call;
    const std::size_t unit = texture - GL_TEXTURE0;
    if (unit >= texture_unit_count) return false;
    (unit == 0 ? now_.texcoord : further_[unit - 1]) = finite(vec4(s, t, r, q));
    (unit == 0 ? given_.texcoord : given_.further_texcoords[unit - 1]) = true;
    return true;
}

bool Sealer::take(const Position& p) {
    if (const auto* v = call_of<execute::vertex>(p)) {
        const auto& [x, y, z, w] = *v;
        return take_vertex({x, y, z, w}, list_.header(p).function);
    }
    if (const auto* v = call_of<execute::begin>(p)) return take_begin(std::get<0>(*v));
    if (call_of<execute::end>(p) != nullptr) return take_end();
    if (const auto* v = call_of<execute::color>(p)) {
        const auto& [r, g, b, a] = *v;
        now_.color = {r, g, b, a};
        return given_.color = true;
    }
    if (const auto* v = call_of<execute::normal>(p)) {
        const auto& [x, y, z] = *v;
        now_.normal = {x, y, z};
        return given_.normal = true;
    }
    if (const auto* v = call_of<execute::tex_coord>(p)) {
        const auto& [s, t, r, q] = *v;
        now_.texcoord = {s, t, r, q};
        return given_.texcoord = true;
    }
    if (const auto* v = call_of<execute::secondary_color>(p)) {
        const auto& [r, g, b] = *v;
        now_.secondary_color = {r, g, b};
        return given_.secondary_color = true;
    }
    if (const auto* v = call_of<execute::fog_coord>(p)) {
        now_.fog_coordinate = std::get<0>(*v);
        return given_.fog_coordinate = true;
    }
    if (const auto* v = call_of<execute::multi_tex_coord>(p)) return take_texcoord(*v);
    if (const auto* v = call_of<execute::edge_flag>(p)) {
        now_.edge_and_material = std::get<0>(*v) != GL_FALSE ? 1u : 0u;
        return given_.edge_flag = true;
    }
    return false;
}

void Sealer::add_step(const Position& begin, const Position& end, std::uint32_t first,
                      std::shared_ptr<SealedRuns> runs) {
    auto& steps = list_.steps_;
    if (begin == end) return;
    if (!runs && !steps.empty() && !steps.back().runs)
        steps.back().end = end;
    else
        steps.push_back({begin, end, first, std::move(runs)});
}

void Sealer::end_group(const Position& p) {
    runs_->is_small = vertices_ < fewest_vertices;
    if (inside_ || vertices_ == 0 || (runs_->is_small && ++small_groups_ > most_small_groups))
        return add_step(group_begin_, p, group_first_, nullptr);
    std::erase_if(runs_->parts, [](const auto& part) { return part.assembly.empty(); });
    runs_->given = *given_to_all_;
    runs_->given_after = given_;
    runs_->last = now_;
    runs_->last_further = further_;
    add_step(group_begin_, p, group_first_, std::move(runs_));
}

void Sealer::seal() {
    begin_group({}, 0);
    for (Position p; p != list_.end(); p = list_.next(p), ++number_) {
        if (take(p)) continue;

        end_group(p);
        const Position after = list_.next(p);
        add_step(p, after, number_, nullptr);
        begin_group(after, number_ + 1);
    }
    end_group(list_.end());
}

void DisplayList::seal() { Sealer(*this).seal(); }

}  // namespace gw::gl
