// Runs the vertex stages on the mesh vertices in use, and on the vertices that clipping made.
#include "gw/fast/vertices/vertex_values.h"

#include "gw/base/prefetch.h"
#include "gw/command_list.h"
#include "gw/fast/vertices/light.h"
#include "gw/fast/vertices/texgen.h"
#include "gw/stages/clip.h"
#include "gw/stages/perspective.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace gw::fast {

namespace {

Rgba to_rgba(const std::array<double, 4>& c) {
    return {std::uint16_t(c[0]), std::uint16_t(c[1]), std::uint16_t(c[2]), std::uint16_t(c[3])};
}

/// Whether a light's colour times the material's is 0. Then its contribution is 0, because it is
/// finite.
bool is_dark(const vec3& light, const vec3& own) {
    for (int c = 0; c < 3; ++c)
        if (!(double(light[c]) * double(own[c]) == 0)) return false;
    return true;
}

/// Whether the light is equally strong everywhere. A finite position is less than 2^300 away, so 0
/// times the square of the distance is 0.
bool is_even(const Light& l, const Draw& draw) {
    if (l.position.w == 0) return true;
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
        largest = std::max(largest, std::abs(double(l.position[i]) / double(l.position.w)));
        for (int k = 0; k < 4; ++k)
            largest = std::max(largest, std::abs(draw.eye_from_object[i][k]));
    }
    return largest < 0x1p150 && l.linear_attenuation == 0 && l.quadratic_attenuation == 0 &&
           l.spot_cos_cutoff <= -1;
}

/// Whether all vertices of this material have one colour, whatever their positions and normals.
bool is_uniform(const Draw& draw, const Material& m) {
    return !draw.lights ||
           std::all_of(draw.lights->begin(), draw.lights->end(), [&](const Light& l) {
               return is_dark(l.Id, m.Kd) && is_dark(l.Is, m.Ks) &&
                      (is_dark(l.Ia, m.Ka) || is_even(l, draw));
           });
}

/// A part's vertices: the mesh vertices in use, by the mesh's indices, and those made by clipping.
struct PartVertices {
    const GeometrySet& set;
    const GeometryPart& part;
    std::size_t end, clipped_end;
    std::span<const std::uint32_t> used, used_front, used_back;

    PartVertices(const GeometrySet& s, std::size_t i)
        : set(s),
          part(s.parts[i]),
          end(s.end_of(i, &GeometryPart::vertex, s.vertex_count())),
          clipped_end(s.end_of(i, &GeometryPart::clipped, s.clipped.size())),
          used(list(i, s.used, &GeometryPart::used)),
          used_front(list(i, s.used_front, &GeometryPart::used_front)),
          used_back(list(i, s.used_back, &GeometryPart::used_back)) {}

    bool is_clipped() const { return part.clipped != clipped_end; }
    /// The part's elements of a vector by vertex.
    template <typename T, typename Allocator>
    std::span<T> of(std::vector<T, Allocator>& values) const {
        return std::span(values).subspan(part.vertex, end - part.vertex);
    }
    /// Calls visit(index in the set) for the vertices that clipping made.
    template <typename Visit>
    void for_each_place(const Visit& visit) const {
        for (std::size_t i = part.clipped; i < clipped_end; ++i)
            for (std::uint32_t k = 0; k < set.clipped[i].count; ++k)
                visit(set.clipped[i].first + k);
    }
    /// Calls store(index in the part, vertex) for the vertices that clipping made.
    template <typename Store>
    void for_each_new(const VertexProgram& program, const Store& store) const {
        for (std::size_t i = part.clipped; i < clipped_end; ++i) {
            const ClippedPrimitive& primitive = set.clipped[i];
            std::vector<Vertex> corners;
            for (std::uint32_t k = 0; k < primitive.sides; ++k)
                corners.push_back(run_vertex(program, primitive.vertex[k]));
            const Clipped clipped = clip(std::move(corners), set.viewport);
            for (std::uint32_t k = 0; k < primitive.count; ++k)
                store(primitive.first - part.vertex + k, clipped.vertices[k]);
        }
    }

private:
    std::span<const std::uint32_t> list(std::size_t i, const std::vector<std::uint32_t>& all,
                                        std::uint32_t GeometryPart::*first) const {
        const std::size_t at = part.*first;
        return std::span(all).subspan(at, set.end_of(i, first, all.size()) - at);
    }
};

/// A draw without its texture.
class Untextured {
public:
    explicit Untextured(const Draw& draw) : draw_(&draw) {
        if (!is_textured(draw)) return;
        copy_ = draw;
        copy_->map = {};
        copy_->more_maps = {};
        draw_ = &*copy_;
    }
    const Draw& operator*() const { return *draw_; }

private:
    std::optional<Draw> copy_;
    const Draw* draw_;
};

/// Prefetches the mesh of a later part, and the colours or normals of a part between. Inlined: GCC
/// leaves out calls of functions that only prefetch.
[[gnu::always_inline]] inline void prefetch_values(const VertexInputs& inputs, std::size_t i,
                                                   bool lit) {
    constexpr std::size_t steps = 8;
    const auto part = [&](std::size_t k) { return k < inputs.draws.size() && inputs.draws[k]; };
    if (part(i + 2 * steps)) {
        prefetch(inputs.set->parts[i + 2 * steps].mesh, 4 * cache_line);
        if (lit) prefetch(inputs.draws[i + 2 * steps], sizeof(Draw));
    }
    if (!part(i + steps)) return;
    const MeshData& mesh = inputs.set->parts[i + steps].mesh->data();
    if (lit)
        prefetch_elements(mesh.normals);
    else
        prefetch_elements(mesh.colors);
}

/// Colours from the mesh. Only vertices that clipping made need the vertex stages.
void color_part(const PartVertices& vertices, const VertexProgram* program, const Draw& draw,
                const Profile& profile, std::span<Rgba> front) {
    const std::vector<vec4>& given = vertices.part.mesh->data().colors;
    if (given.empty())
        std::fill(front.begin(), front.end(),
                  quantize_color(given_color(draw, 0), profile.color_bits));
    else
        quantize_colors({given, vertices.used, profile.color_bits}, front);
    if (program)
        vertices.for_each_new(*program,
                              [&](std::size_t i, const Vertex& v) { front[i] = to_rgba(v.color); });
}

/// Lights the part's vertices. Returns whether the part has one colour.
bool light_part(const PartVertices& vertices, const VertexProgram& program, PreparedLights& lights,
                std::span<Rgba> front, std::span<Rgba> back) {
    if (vertices.used.empty()) return true;
    const auto is_uniform_on = [&](Face side) {
        return is_uniform(*program.draw, material_of(program, vertices.used[0], side));
    };
    if (program.is_affine && program.has_one_material && is_uniform_on(Face::Front) &&
        (back.empty() || is_uniform_on(Face::Back))) {
        const Vertex vertex = run_vertex(program, vertices.used[0]);
        std::fill(front.begin(), front.end(), to_rgba(vertex.color));
        std::fill(back.begin(), back.end(), to_rgba(vertex.back_color));
        return true;
    }
    light_vertices(program, lights, back.empty() ? vertices.used : vertices.used_front, false,
                   front);
    if (!back.empty()) light_vertices(program, lights, vertices.used_back, true, back);
    vertices.for_each_new(program, [&](std::size_t i, const Vertex& v) {
        front[i] = to_rgba(v.color);
        if (!back.empty()) back[i] = to_rgba(v.back_color);
    });
    return false;
}

/// The colours of a part's vertices, secondary ones included: one after the other.
void sum_part(const PartVertices& vertices, const VertexProgram& program, VertexColors& out) {
    const auto store = [](std::span<Rgba> to, std::size_t i, const std::array<double, 4>& color) {
        if (!to.empty()) to[i] = to_rgba(color);
    };
    const auto of = [&](std::vector<Rgba>& all) {
        return all.empty() ? std::span<Rgba>() : vertices.of(all);
    };
    const std::span<Rgba> front = of(out.front), back = of(out.back), secondary = of(out.secondary),
                          back_secondary = of(out.back_secondary);
    const auto put = [&](std::size_t i, const Vertex& v) {
        store(front, i, v.color);
        store(back, i, v.back_color);
        store(secondary, i, v.secondary);
        store(back_secondary, i, v.back_secondary);
    };
    for (const std::uint32_t v : vertices.used) put(v, run_vertex(program, v));
    vertices.for_each_new(program, put);
}

/// The programs of draws, whose states `change` reduces to what is asked. Neighbours under one state
/// and transform share theirs.
class Programs {
public:
    Programs(const Profile& profile, void (*change)(State&)) : profile_(profile), change_(change) {}
    const VertexProgram& of(const Draw& draw, const State& state) {
        use(state);
        if (program_ && draw.eye_from_object == transform_) {
            change_draw(*program_, draw);
        } else {
            program_ = vertex_program(state_, draw, profile_);
            transform_ = draw.eye_from_object;
        }
        return *program_;
    }

private:
    void use(const State& state) {
        if (given_ == &state) return;
        given_ = &state;
        state_ = state;
        change_(state_);
        program_.reset();
    }

    const Profile& profile_;
    void (*change_)(State&);
    const State* given_ = nullptr;
    State state_;
    std::optional<VertexProgram> program_;
    dmat4 transform_{1};
};

bool is_one_color(std::span<const Rgba> colors) {
    return std::adjacent_find(colors.begin(), colors.end(), std::not_equal_to<>()) == colors.end();
}

/// Whether each primitive of a part has one colour, like a face with its own normal or colour.
bool has_one_color_each(const GeometrySet& set, std::size_t part, const VertexColors& colors) {
    const auto first = set.primitives.begin() + set.parts[part].primitive,
               end = set.primitives.begin() +
                     std::ptrdiff_t(
                         set.end_of(part, &GeometryPart::primitive, set.primitives.size()));
    return std::all_of(first, end, [&](const SetupPrimitive& p) {
        const Rgba* const of = colors.of(p).data();
        const Rgba& color = of[p.provoking];
        return of[p.vertex[0]] == color && of[p.vertex[1]] == color && of[p.vertex[2]] == color;
    });
}

}  // namespace

void shade_vertices(VertexColors& out, const Profile& profile) {
    const auto& [set, first, newest, draws, states, unit] = out.inputs;
    Programs programs(profile, [](State& s) { s.fog.enable = false; });
    PreparedLights lights;
    const bool lit = first->color_source == ColorSource::Lighting;
    out.front.resize(set->vertex_count());
    if (lit && first->lighting.two_side) out.back.resize(set->vertex_count());
    const bool sums = sums_colors(*first);
    if (sums) out.secondary.resize(out.front.size());
    if (sums) out.back_secondary.resize(out.back.size());
    out.uniform.assign(set->parts.size(), 0);
    for (std::size_t i = 0; i < set->parts.size(); ++i) {
        if (!draws[i]) continue;
        prefetch_values(out.inputs, i, lit);
        const PartVertices vertices(*set, i);
        const std::span<Rgba> front = vertices.of(out.front);
        const std::span<Rgba> back = out.back.empty() ? std::span<Rgba>() : vertices.of(out.back);
        bool uniform = false;
        if (lit || sums || vertices.is_clipped()) {
            const Untextured draw(*draws[i]);
            const VertexProgram& program = programs.of(*draw, *states[i]);
            if (sums)
                sum_part(vertices, program, out);
            else if (lit)
                uniform = light_part(vertices, program, lights, front, back);
            else
                color_part(vertices, &program, *draws[i], profile, front);
        } else {
            color_part(vertices, nullptr, *draws[i], profile, front);
        }
        uniform = uniform || (back.empty() && is_one_color(front));
        out.uniform[i] = uniform || has_one_color_each(*set, i, out);
    }
}

void fog_vertices(VertexFog& out, const Profile& profile) {
    const auto& [set, first, newest, draws, states, unit] = out.inputs;
    Programs programs(profile, [](State& s) { s.color_source = ColorSource::PolygonId; });
    out.value.resize(set->vertex_count());
    for (std::size_t i = 0; i < set->parts.size(); ++i) {
        if (!draws[i]) continue;
        const PartVertices vertices(*set, i);
        const Untextured draw(*draws[i]);
        const VertexProgram& program = programs.of(*draw, *states[i]);
        const std::span<double> value = vertices.of(out.value);
        for (const std::uint32_t v : vertices.used) {
            const dvec4 p_object = object_position(draws[i]->mesh->data(), v);
            value[v] =
                fog_of(program, v, eye_point(transform(draws[i]->eye_from_object, p_object)).z);
        }
        vertices.for_each_new(program,
                              [&](std::size_t v, const Vertex& vertex) { value[v] = vertex.fog; });
    }
}

namespace {

/// Whether s or t of a primitive of the used parts is wide. Most meshes as a whole are not.
bool are_wide(const VertexTexcoords& texcoords) {
    const auto spans_more = [](const dvec2& least, const dvec2& greatest) {
        return is_wide(least.x, greatest.x) || is_wide(least.y, greatest.y);
    };
    const VertexInputs& inputs = texcoords.inputs;
    dvec2 least(0), greatest(0);
    const auto include = [&](std::size_t vertex) {
        const dvec2 st(texcoords.strq[vertex]);
        least = glm::min(least, st);
        greatest = glm::max(greatest, st);
    };
    for (std::size_t i = 0; i < inputs.set->parts.size(); ++i) {
        if (!inputs.draws[i]) continue;
        const PartVertices vertices(*inputs.set, i);
        for (const std::uint32_t v : vertices.used) include(vertices.part.vertex + v);
        vertices.for_each_place(include);
    }
    if (!spans_more(least, greatest)) return false;
    return std::ranges::any_of(inputs.set->primitives, [&](const SetupPrimitive& p) {
        if (!inputs.draws[p.part]) return false;
        const dvec2 a(texcoords.strq[p.vertex[0]]), b(texcoords.strq[p.vertex[1]]),
            c(texcoords.strq[p.vertex[2]]);
        return spans_more(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)));
    });
}

}  // namespace

void texture_vertices(VertexTexcoords& out, const Profile& profile) {
    const auto& [set, first, newest, draws, states, unit] = out.inputs;
    Programs programs(profile, [](State& s) {
        s.color_source = ColorSource::PolygonId;
        s.fog.enable = false;
    });
    if (out.strq.size() < set->vertex_count()) {
        out.strq.clear();
        out.strq.resize(set->vertex_count());
    }
    for (std::size_t i = 0; i < set->parts.size(); ++i) {
        if (!draws[i]) continue;
        const PartVertices vertices(*set, i);
        const std::span<dvec4> strq = vertices.of(out.strq);
        const std::vector<vec2>& given = draws[i]->mesh->data().texcoords;
        const TextureState& texture = texture_of(*states[i], unit);
        const bool as_given = unit == 0 && texture.gen == TexGen::None && !given.empty() &&
                              draws[i]->mesh->data().texcoords_rq.empty() &&
                              texture.matrix == dmat4(1) && !is_one_dimensional(*draws[i]);
        if (as_given)
            for (const std::uint32_t v : vertices.used) strq[v] = {given[v].x, given[v].y, 0, 1};
        if (as_given && !vertices.is_clipped()) continue;
        const VertexProgram& program = programs.of(*draws[i], *states[i]);
        if (!as_given) generate_texcoords(program, unit, vertices.used, strq);
        vertices.for_each_new(program, [&, unit = unit](std::size_t v, const Vertex& vertex) {
            strq[v] = vertex.texcoord_of(unit);
        });
    }
    out.are_wide = are_wide(out);
}

}  // namespace gw::fast
