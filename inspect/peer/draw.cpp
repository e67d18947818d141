// Matrices, fog and vertices of a draw.
#include "inspect/peer/commands.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/fog.h"
#include "gw/stages/vertex.h"
#include "inspect/peer/gl.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gw::peer {
namespace {

/// The projection of a program's recording: gl/draw/machine_state.cpp moved depths by 2^-22 towards
/// the middle, and an OpenGL that gets them rounded to floats would do so again.
dmat4 as_given(dmat4 projection) {
    constexpr double moved = 1 - 0x1p-22;
    dmat4 given = projection;
    for (int column = 0; column < 4; ++column) {
        const double moved_element = projection[column][2];
        const auto element = float(moved_element / moved);
        if (double(element) * moved != moved_element) return projection;
        given[column][2] = element;
    }
    return given;
}

/// Jitter as a translation of clip coordinates: a whole number of the profile's sub-pixel units.
dmat4 jittered(const State& s, int subpixel_bits, int width, int height) {
    const bool whole = s.viewport.width == 0 && s.viewport.height == 0;
    const double scale = double(1 << subpixel_bits);
    dmat4 translation{1};
    translation[3][0] = 2 * s.jitter.x / (scale * (whole ? width : s.viewport.width));
    translation[3][1] = 2 * s.jitter.y / (scale * (whole ? height : s.viewport.height));
    return product(translation, as_given(s.projection));
}

void load(GLenum mode, const dmat4& m) {
    gl().MatrixMode(mode);
    gl().LoadMatrixd(&m[0][0]);
}

/// A draw between glBegin and glEnd.
class Emitter {
public:
    Emitter(const Draw& draw, const State& state, const Profile& profile,
            const TextureTargets& targets)
        : draw_(draw),
          state_(state),
          profile_(profile),
          targets_(targets),
          program_(vertex_program(state, draw, profile)) {
        for (std::uint32_t i = 0; i < draw.mesh->vertex_count(); ++i)
            vertices_.push_back(run_vertex(program_, i));
    }

    bool fragment_fog() const { return program_.fragment_fog; }

    void triangles() const {
        if (state_.color_source == ColorSource::Lighting && state_.lighting.two_side)
            return lit_triangles();
        gl().Begin(GL_TRIANGLES);
        for (const Triangle& t : draw_.mesh->triangles()) corners(t, Face::Front);
        gl().End();
    }
    /// A strip stays one: its stipple goes on.
    void strip() const {
        gl().Begin(GL_LINE_STRIP);
        std::uint32_t ordinal = 0;
        for (const auto& [first, second] : draw_.mesh->lines()) {
            if (ordinal == 0) vertex(first, first, ordinal);
            vertex(second, second, ordinal++);
        }
        gl().End();
    }
    void lines() const {
        if (draw_.mesh->data().primitive == Primitive::LineStrip) return strip();
        gl().Begin(GL_LINES);
        std::uint32_t ordinal = 0;
        for (const auto& line : draw_.mesh->lines()) {
            for (const std::uint32_t v : line) vertex(v, line[1], ordinal);
            ++ordinal;
        }
        gl().End();
    }
    void points() const {
        gl().Begin(GL_POINTS);
        std::uint32_t ordinal = 0;
        for (const std::uint32_t v : draw_.mesh->points()) vertex(v, v, ordinal++);
        gl().End();
    }

private:
    /// OpenGL chooses the side after clipping. So each triangle is drawn with the colours of one
    /// side while the other is culled, and then the other way round.
    void lit_triangles() const {
        const CullState& cull = state_.cull;
        gl().Enable(GL_CULL_FACE);
        for (const Triangle& t : draw_.mesh->triangles())
            for (const Face side : {Face::Front, Face::Back}) {
                if (cull.enable && (cull.face == side || cull.face == Face::FrontAndBack)) continue;
                gl().CullFace(side == Face::Front ? GL_BACK : GL_FRONT);
                gl().Begin(GL_TRIANGLES);
                corners(t, side);
                gl().End();
            }
        enable(GL_CULL_FACE, cull.enable);
        gl().CullFace(token(cull.face));
    }
    void corners(const Triangle& t, Face side) const {
        for (std::size_t k = 0; k < 3; ++k) {
            gl().EdgeFlag((t.edges >> k & 1) != 0);
            vertex(t.vertex[k], t.provoking, t.polygon, side);
        }
    }
    void vertex(std::uint32_t index, std::uint32_t provoking, std::uint32_t polygon,
                Face side = Face::Front) const {
        const Vertex& v = vertices_[index];
        const dvec4 p = object_position(draw_.mesh->data(), index);
        color(state_.shade_model == ShadeModel::Flat ? vertices_[provoking] : v, polygon, side);
        gl().TexCoord4d(v.texcoord.x, v.texcoord.y, v.texcoord.z, v.texcoord.w);
        for (std::size_t unit = 1; unit < targets_.size(); ++unit)
            if (targets_[unit] != 0) further_texcoord(unit, v.texcoord_of(unit));
        if (gl().FogCoordd) gl().FogCoordd(fog_coordinate(v, p));
        gl().Vertex4f(float(p.x), float(p.y), float(p.z), float(p.w));
    }
    static void further_texcoord(std::size_t unit, const dvec4& c) {
        gl().MultiTexCoord4d(GL_TEXTURE0 + static_cast<GLenum>(unit), c.x, c.y, c.z, c.w);
    }
    void color(const Vertex& v, std::uint32_t polygon, Face side) const {
        if (state_.color_source == ColorSource::PolygonId) {
            const std::uint32_t id =
                (draw_.id_base + draw_.mesh->polygon_id(polygon)) >> draw_.id_shift;
            gl().Color4ub(id & 255, (id >> 8) & 255, (id >> 16) & 255, 255);
            return;
        }
        const auto bytes = [](const std::array<double, 4>& color) {
            std::array<GLubyte, 4> out{};
            std::transform(color.begin(), color.end(), out.begin(),
                           [](double x) { return GLubyte(x); });
            return out;
        };
        const bool front = side == Face::Front;
        gl().Color4ubv(bytes(front ? v.color : v.back_color).data());
        if (sums_colors(state_))
            required(gl().SecondaryColor3ubv, "glSecondaryColor",
                     "a secondary colour")(bytes(front ? v.secondary : v.back_secondary).data());
    }
    double fog_coordinate(const Vertex& v, const dvec4& p) const {
        if (!program_.fragment_fog) return 1 - v.fog / max_of_bits(profile_.color_bits);
        if (state_.fog.source == FogSource::Coordinate) return v.fog * program_.fog_depth;
        return std::max(-eye_point(transform(draw_.eye_from_object, p)).z, 0.0);
    }

    const Draw& draw_;
    const State& state_;
    const Profile& profile_;
    const TextureTargets& targets_;
    VertexProgram program_;
    std::vector<Vertex> vertices_;
};

}  // namespace

void apply(const FogState& fog, bool per_fragment, bool on) {
    enable(GL_FOG, on);
    if (on && fog.source == FogSource::Coordinate)
        required(gl().FogCoordd, "glFogCoord", "fog.source");
    if (gl().FogCoordd)
        gl().Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    else if (on && !per_fragment)
        refuse("glFogCoord", "fog at the vertex");
    gl().Fogi(GL_FOG_MODE, static_cast<GLint>(per_fragment ? token(fog.mode) : GL_LINEAR));
    gl().Fogf(GL_FOG_DENSITY, fog.density);
    gl().Fogf(GL_FOG_START, per_fragment ? fog.start : 0);
    gl().Fogf(GL_FOG_END, per_fragment ? fog.end : 1);
    gl().Fogfv(GL_FOG_COLOR, &fog.color[0]);
}

void draw(const Draw& draw, const State& state, const Profile& profile, int width, int height,
          const TextureTargets& targets) {
    const bool shaded = state.color_source != ColorSource::PolygonId;
    const Emitter emitter(draw, state, profile, targets);
    load(GL_PROJECTION, jittered(state, profile.subpixel_bits, width, height));
    load(GL_MODELVIEW, draw.eye_from_object);
    apply(state.fog, emitter.fragment_fog(), shaded && state.fog.enable);
    if (gl().SecondaryColor3ubv) enable(GL_COLOR_SUM, sums_colors(state));
    if (shaded) enable(targets, true);
    switch (draw.mesh->kind()) {
        case MeshKind::Triangles: emitter.triangles(); break;
        case MeshKind::Lines: emitter.lines(); break;
        case MeshKind::Points: emitter.points(); break;
    }
    enable(targets, false);
    gl().Disable(GL_FOG);
}

}  // namespace gw::peer
