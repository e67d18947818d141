// Each group of the state in both directions.
#include "inspect/recording/file_values.h"

#include <cmath>

namespace gw::inspect {
namespace {

using inspect::from_file;
using inspect::to_file;

static_assert(int(CompareFunc::Always) == int(gwt::CompareFunc::MAX));
static_assert(int(StencilOp::DecrWrap) == int(gwt::StencilOp::MAX));
static_assert(int(BlendFactor::OneMinusConstantAlpha) == int(gwt::BlendFactor::MAX));
static_assert(int(BlendEquation::Max) == int(gwt::BlendEquation::MAX));
static_assert(int(CoordinateMode::SphereMap) == int(gwt::CoordinateMode::MAX));
static_assert(int(ColorMaterial::AmbientAndDiffuse) == int(gwt::ColorMaterial::MAX));
static_assert(int(Wrap::BorderClamp) == int(gwt::Wrap::MAX));
static_assert(int(TextureFormat::Intensity) == int(gwt::TextureFormat::MAX));
static_assert(int(DrawBuffer::FrontAndBack) == int(gwt::DrawBuffer::MAX));
static_assert(int(ReadBuffer::Back) == int(gwt::ReadBuffer::MAX));
static_assert(int(LogicOp::Set) == int(gwt::LogicOp::MAX));
static_assert(int(MinFilter::LinearMipmapLinear) == int(gwt::MinFilter::MAX));
static_assert(int(TexEnv::Replace) == int(gwt::TexEnv::MAX));
static_assert(int(TexGen::PerCoordinate) == int(gwt::TexGen::MAX));
static_assert(int(ColorSource::PolygonId) == int(gwt::ColorSource::MAX));
static_assert(int(FogCoordinate::Fragment) == int(gwt::FogCoordinate::MAX));

gwt::CompareFunc to_file(CompareFunc f) { return file_enum<gwt::CompareFunc>(f); }
gwt::StencilOp to_file(StencilOp op) { return file_enum<gwt::StencilOp>(op); }
gwt::BlendFactor to_file(BlendFactor f) { return file_enum<gwt::BlendFactor>(f); }
CompareFunc from_file(gwt::CompareFunc f) { return our_enum<CompareFunc>(f); }
StencilOp from_file(gwt::StencilOp op) { return our_enum<StencilOp>(op); }
BlendFactor from_file(gwt::BlendFactor f) { return our_enum<BlendFactor>(f); }

gwt::Viewport to_file(const ViewportState& v) { return {v.x, v.y, v.width, v.height}; }
ViewportState from_file(const gwt::Viewport& v) { return {v.x(), v.y(), v.width(), v.height()}; }

gwt::DepthRange to_file(const DepthRangeState& r) { return {r.near_value, r.far_value}; }
DepthRangeState from_file(const gwt::DepthRange& r) { return {r.near_value(), r.far_value()}; }

gwt::ClipPlane to_file(const ClipPlane& p) { return {p.enable, to_file(p.plane)}; }
ClipPlane from_file(const gwt::ClipPlane& p) { return {p.enable(), from_file(p.plane())}; }

gwt::Cull to_file(const CullState& c) {
    return {c.enable, file_enum<gwt::Face>(c.face), file_enum<gwt::Winding>(c.front)};
}
CullState from_file(const gwt::Cull& c) {
    return {c.enable(), our_enum<Face>(c.face()), our_enum<Winding>(c.front())};
}

gwt::PolygonOffset to_file(const PolygonOffsetState& o) { return {o.enable, o.factor, o.units}; }
/// All but the members of version 2.
PolygonOffsetState from_file(const gwt::PolygonOffset& o) {
    return {.enable = o.enable(), .factor = o.factor(), .units = o.units()};
}

gwt::Jitter to_file(const JitterState& j) { return {j.x, j.y}; }
JitterState from_file(const gwt::Jitter& j) { return {j.x(), j.y()}; }

gwt::Lighting to_file(const LightingState& l) {
    return {l.local_viewer, l.two_side, to_file(l.model_ambient)};
}
/// All but the members of version 2.
LightingState from_file(const gwt::Lighting& l) {
    return {.local_viewer = l.local_viewer(),
            .two_side = l.two_side(),
            .model_ambient = from_file(l.model_ambient())};
}

gwt::ColorMaterialUse to_file(const ColorMaterialState& c) {
    return {c.enable, file_enum<gwt::Face>(c.face), file_enum<gwt::ColorMaterial>(c.mode)};
}
ColorMaterialState from_file(const gwt::ColorMaterialUse& c) {
    return {c.enable(), our_enum<Face>(c.face()), our_enum<ColorMaterial>(c.mode())};
}

gwt::LineStipple to_file(const LineStippleState& l) { return {l.enable, l.factor, l.pattern}; }
LineStippleState from_file(const gwt::LineStipple& l) {
    return {l.enable(), l.factor(), l.pattern()};
}

gwt::CoordinateGen to_file(const CoordinateGen& c) {
    return {file_enum<gwt::CoordinateMode>(c.mode), to_file(c.plane)};
}
CoordinateGen from_file(const gwt::CoordinateGen& c) {
    return {our_enum<CoordinateMode>(c.mode()), from_file(c.plane())};
}

gwt::Fog to_file(const FogState& f) {
    return {f.enable,
            file_enum<gwt::FogMode>(f.mode),
            f.density,
            f.start,
            f.end,
            to_file(f.color),
            file_enum<gwt::FogCoordinate>(f.coordinate)};
}
FogState from_file(const gwt::Fog& f) {
    return {.enable = f.enable(),
            .mode = our_enum<FogMode>(f.mode()),
            .density = f.density(),
            .start = f.start(),
            .end = f.end(),
            .color = from_file(f.color()),
            .coordinate = our_enum<FogCoordinate>(f.coordinate())};
}

gwt::TextureLookup to_file(const TextureState& t) {
    return {file_enum<gwt::MinFilter>(t.min_filter),
            file_enum<gwt::MagFilter>(t.mag_filter),
            file_enum<gwt::Wrap>(t.wrap_s),
            file_enum<gwt::Wrap>(t.wrap_t),
            file_enum<gwt::TexEnv>(t.env),
            to_file(t.env_color),
            file_enum<gwt::TexGen>(t.gen),
            t.eta,
            to_file(t.eye_linear),
            t.shadow_compare};
}
/// All but the members of version 2.
TextureState from_file(const gwt::TextureLookup& t) {
    return {.min_filter = our_enum<MinFilter>(t.min_filter()),
            .mag_filter = our_enum<MagFilter>(t.mag_filter()),
            .wrap_s = our_enum<Wrap>(t.wrap_s()),
            .wrap_t = our_enum<Wrap>(t.wrap_t()),
            .env = our_enum<TexEnv>(t.env()),
            .env_color = from_file(t.env_color()),
            .gen = our_enum<TexGen>(t.gen()),
            .eta = t.eta(),
            .eye_linear = from_file(t.eye_linear()),
            .shadow_compare = t.shadow_compare()};
}

gwt::Scissor to_file(const ScissorState& s) { return {s.test, to_file(s.box)}; }
ScissorState from_file(const gwt::Scissor& s) { return {s.test(), from_file(s.box())}; }

gwt::Alpha to_file(const AlphaState& a) { return {a.test, to_file(a.func), a.ref}; }
AlphaState from_file(const gwt::Alpha& a) { return {a.test(), from_file(a.func()), a.ref()}; }

template <typename Face>
gwt::StencilFace face_to_file(const Face& f) {
    const auto byte = [](auto word) { return static_cast<std::uint8_t>(to_file(word)); };
    return {byte(f.func), f.ref, f.mask, byte(f.fail), byte(f.zfail), byte(f.zpass), f.write_mask};
}
StencilFace from_file(const gwt::StencilFace& f) {
    const auto op = [](std::uint8_t byte) { return from_file(gwt::StencilOp{byte}); };
    return {.func = from_file(gwt::CompareFunc{f.func()}),
            .ref = f.ref(),
            .mask = f.mask(),
            .fail = op(f.fail()),
            .zfail = op(f.zfail()),
            .zpass = op(f.zpass()),
            .write_mask = f.write_mask()};
}
gwt::Stencil to_file(const StencilState& s) {
    return {s.test, face_to_file(s), s.two_side, face_to_file(s.back)};
}
StencilState from_file(const gwt::Stencil& s) {
    const StencilFace f = from_file(s.front());
    return {.test = s.test(),
            .func = f.func,
            .ref = f.ref,
            .mask = f.mask,
            .fail = f.fail,
            .zfail = f.zfail,
            .zpass = f.zpass,
            .write_mask = f.write_mask,
            .two_side = s.two_side(),
            .back = from_file(s.back())};
}

gwt::Depth to_file(const DepthState& d) { return {d.test, to_file(d.func), d.mask}; }
DepthState from_file(const gwt::Depth& d) { return {d.test(), from_file(d.func()), d.mask()}; }

gwt::Blend to_file(const BlendState& b) { return {b.enable, to_file(b.src), to_file(b.dst)}; }
/// All but the members of version 2.
BlendState from_file(const gwt::Blend& b) {
    return {.enable = b.enable(), .src = from_file(b.src()), .dst = from_file(b.dst())};
}

gwt::LogicOperation to_file(const LogicOpState& l) {
    return {l.enable, file_enum<gwt::LogicOp>(l.op)};
}
LogicOpState from_file(const gwt::LogicOperation& l) {
    return {l.enable(), our_enum<LogicOp>(l.op())};
}

gwt::ColorMask to_file(const ColorMask& m) { return {m.r, m.g, m.b, m.a}; }
ColorMask from_file(const gwt::ColorMask& m) { return {m.r(), m.g(), m.b(), m.a()}; }

flatbuffers::Offset<flatbuffers::Vector<const gwt::ClipPlane*>> clip_planes_to_file(
    flatbuffers::FlatBufferBuilder& out, const State& state) {
    if (state.clip_planes == State{}.clip_planes) return 0;
    std::vector<gwt::ClipPlane> planes;
    for (const ClipPlane& plane : state.clip_planes) planes.push_back(to_file(plane));
    return out.CreateVectorOfStructs(planes);
}

flatbuffers::Offset<flatbuffers::Vector<const gwt::CoordinateGen*>> coordinates_to_file(
    flatbuffers::FlatBufferBuilder& out, const State& state) {
    if (state.texture.coordinates == TextureState{}.coordinates) return 0;
    std::vector<gwt::CoordinateGen> all;
    for (const CoordinateGen& c : state.texture.coordinates) all.push_back(to_file(c));
    return out.CreateVectorOfStructs(all);
}

void read_coordinates(const flatbuffers::Vector<const gwt::CoordinateGen*>* stored, State& state) {
    if (!stored || stored->size() == 0) return;
    if (stored->size() != 4)
        throw Error(fmt::format("{} texture coordinates in a state; expected 4", stored->size()));
    for (unsigned i = 0; i < 4; ++i) state.texture.coordinates[i] = from_file(*stored->Get(i));
}

void read_polygon_stipple(const flatbuffers::Vector<std::uint32_t>* stored, State& state) {
    if (!stored || stored->size() == 0) return;
    std::array<std::uint32_t, 32> rows;
    if (stored->size() != rows.size())
        throw Error(
            fmt::format("{} rows of a polygon stipple; expected {}", stored->size(), rows.size()));
    std::copy(stored->begin(), stored->end(), rows.begin());
    state.polygon_stipple.pattern = std::make_shared<const std::array<std::uint32_t, 32>>(rows);
}

void read_clip_planes(const flatbuffers::Vector<const gwt::ClipPlane*>* planes, State& state) {
    if (!planes || planes->size() == 0) return;
    if (planes->size() != max_clip_planes)
        throw Error(
            fmt::format("{} clip planes in a state; expected {}", planes->size(), max_clip_planes));
    for (unsigned i = 0; i < planes->size(); ++i) state.clip_planes[i] = from_file(*planes->Get(i));
}

/// Whether a size is one of version 1: whole.
bool is_whole(float size) { return size == std::floor(size) && std::abs(size) < 65536; }
bool has_whole_sizes(const State& s) { return is_whole(s.point_size) && is_whole(s.line_width); }

bool is_constant(BlendFactor factor) { return factor >= BlendFactor::ConstantColor; }

/// A group that is there.
template <typename File, typename Group>
void read(const File* stored, Group& group) {
    if (stored) group = from_file(*stored);
}

}  // namespace

flatbuffers::Offset<gwt::State> to_file(flatbuffers::FlatBufferBuilder& out, const State& s) {
    static const State initial;
    const auto planes = clip_planes_to_file(out, s);
    const auto coordinates = coordinates_to_file(out, s);
    flatbuffers::Offset<flatbuffers::Vector<std::uint32_t>> polygon_stipple;
    if (s.polygon_stipple.pattern)
        polygon_stipple = out.CreateVector(s.polygon_stipple.pattern->data(), 32);
    gwt::StateBuilder b(out);
    const auto add = [&](auto add_group, auto State::*group) {
        if (s.*group == initial.*group) return;
        const auto stored = to_file(s.*group);
        (b.*add_group)(&stored);
    };
    add(&gwt::StateBuilder::add_projection, &State::projection);
    add(&gwt::StateBuilder::add_viewport, &State::viewport);
    add(&gwt::StateBuilder::add_depth_range, &State::depth_range);
    b.add_clip_planes(planes);
    add(&gwt::StateBuilder::add_cull, &State::cull);
    b.add_polygon_mode(file_enum<gwt::PolygonMode>(s.polygon_mode));
    add(&gwt::StateBuilder::add_polygon_offset, &State::polygon_offset);
    add(&gwt::StateBuilder::add_jitter, &State::jitter);
    const gwt::Sizes sizes{s.point_size, s.line_width};
    if (has_whole_sizes(s)) {
        b.add_point_size(int(s.point_size));
        b.add_line_width(int(s.line_width));
    }
    b.add_shade_model(file_enum<gwt::ShadeModel>(s.shade_model));
    b.add_color_source(file_enum<gwt::ColorSource>(s.color_source));
    add(&gwt::StateBuilder::add_lighting, &State::lighting);
    add(&gwt::StateBuilder::add_fog, &State::fog);
    add(&gwt::StateBuilder::add_texture, &State::texture);
    add(&gwt::StateBuilder::add_scissor, &State::scissor);
    add(&gwt::StateBuilder::add_alpha, &State::alpha);
    add(&gwt::StateBuilder::add_stencil, &State::stencil);
    add(&gwt::StateBuilder::add_depth, &State::depth);
    add(&gwt::StateBuilder::add_blend, &State::blend);
    add(&gwt::StateBuilder::add_color_mask, &State::color_mask);
    b.add_blend_equation(file_enum<gwt::BlendEquation>(s.blend.equation));
    const auto blend_color = to_file(s.blend.color);
    if (s.blend.color != initial.blend.color) b.add_blend_color(&blend_color);
    add(&gwt::StateBuilder::add_logic_op, &State::logic_op);
    b.add_normalize(s.normalize);
    const auto follows = to_file(s.lighting.color_material);
    if (s.lighting.color_material != initial.lighting.color_material)
        b.add_color_material(&follows);
    b.add_coordinates(coordinates);
    const auto matrix = to_file(s.texture.matrix);
    if (s.texture.matrix != initial.texture.matrix) b.add_texture_matrix(&matrix);
    const auto border_color = to_file(s.texture.border_color);
    if (s.texture.border_color != initial.texture.border_color) b.add_border_color(&border_color);
    b.add_offset_lines(s.polygon_offset.lines);
    b.add_offset_points(s.polygon_offset.points);
    b.add_two_side_polygon_mode(s.two_side_polygon_mode);
    b.add_back_polygon_mode(file_enum<gwt::PolygonMode>(s.back_polygon_mode));
    add(&gwt::StateBuilder::add_line_stipple, &State::line_stipple);
    b.add_polygon_stipple(polygon_stipple);
    if (!has_whole_sizes(s)) b.add_sizes(&sizes);
    b.add_point_smooth(s.point_smooth);
    b.add_line_smooth(s.line_smooth);
    b.add_polygon_smooth(s.polygon_smooth);
    b.add_draw_buffer(file_enum<gwt::DrawBuffer>(s.draw_buffer));
    b.add_read_buffer(file_enum<gwt::ReadBuffer>(s.read_buffer));
    return b.Finish();
}

bool needs_version_2(const State& s) {
    const State initial;
    const BlendState& b = s.blend;
    return b.equation != initial.blend.equation || b.color != initial.blend.color ||
           is_constant(b.src) || is_constant(b.dst) || s.logic_op != initial.logic_op ||
           !s.normalize || s.lighting.color_material != initial.lighting.color_material ||
           s.texture.gen == TexGen::PerCoordinate ||
           s.texture.coordinates != initial.texture.coordinates ||
           s.texture.matrix != initial.texture.matrix ||
           s.texture.border_color != initial.texture.border_color ||
           s.texture.wrap_s == Wrap::BorderClamp || s.texture.wrap_t == Wrap::BorderClamp ||
           s.polygon_offset.lines || s.polygon_offset.points || s.two_side_polygon_mode ||
           s.back_polygon_mode != initial.back_polygon_mode ||
           s.line_stipple != initial.line_stipple || s.polygon_stipple.pattern || antialiases(s) ||
           !has_whole_sizes(s) || s.draw_buffer != initial.draw_buffer ||
           s.read_buffer != initial.read_buffer;
}

State from_file(const gwt::State& f) {
    State s;
    read(f.projection(), s.projection);
    read(f.viewport(), s.viewport);
    read(f.depth_range(), s.depth_range);
    read_clip_planes(f.clip_planes(), s);
    read(f.cull(), s.cull);
    s.polygon_mode = our_enum<PolygonMode>(f.polygon_mode());
    read(f.polygon_offset(), s.polygon_offset);
    read(f.jitter(), s.jitter);
    s.point_size = f.sizes() ? f.sizes()->point() : float(f.point_size());
    s.line_width = f.sizes() ? f.sizes()->line() : float(f.line_width());
    s.point_smooth = f.point_smooth();
    s.line_smooth = f.line_smooth();
    s.polygon_smooth = f.polygon_smooth();
    s.shade_model = our_enum<ShadeModel>(f.shade_model());
    s.color_source = our_enum<ColorSource>(f.color_source());
    read(f.lighting(), s.lighting);
    read(f.fog(), s.fog);
    read(f.texture(), s.texture);
    read(f.scissor(), s.scissor);
    read(f.alpha(), s.alpha);
    read(f.stencil(), s.stencil);
    read(f.depth(), s.depth);
    read(f.blend(), s.blend);
    read(f.color_mask(), s.color_mask);
    s.blend.equation = our_enum<BlendEquation>(f.blend_equation());
    read(f.blend_color(), s.blend.color);
    read(f.logic_op(), s.logic_op);
    s.normalize = f.normalize();
    read(f.color_material(), s.lighting.color_material);
    read_coordinates(f.coordinates(), s);
    read(f.texture_matrix(), s.texture.matrix);
    read(f.border_color(), s.texture.border_color);
    s.polygon_offset.lines = f.offset_lines();
    s.polygon_offset.points = f.offset_points();
    s.two_side_polygon_mode = f.two_side_polygon_mode();
    s.back_polygon_mode = our_enum<PolygonMode>(f.back_polygon_mode());
    read(f.line_stipple(), s.line_stipple);
    read_polygon_stipple(f.polygon_stipple(), s);
    s.draw_buffer = our_enum<DrawBuffer>(f.draw_buffer());
    s.read_buffer = our_enum<ReadBuffer>(f.read_buffer());
    return s;
}

}  // namespace gw::inspect
