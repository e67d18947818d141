// Each group of the state in both directions.
#include "inspect/recording/file_values.h"

namespace gw::inspect {
namespace {

using inspect::from_file;
using inspect::to_file;

static_assert(int(CompareFunc::Always) == int(gwt::CompareFunc::MAX));
static_assert(int(StencilOp::DecrWrap) == int(gwt::StencilOp::MAX));
static_assert(int(BlendFactor::SrcAlphaSaturate) == int(gwt::BlendFactor::MAX));
static_assert(int(MinFilter::LinearMipmapLinear) == int(gwt::MinFilter::MAX));
static_assert(int(TexEnv::Replace) == int(gwt::TexEnv::MAX));
static_assert(int(TexGen::EyeLinear) == int(gwt::TexGen::MAX));
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
PolygonOffsetState from_file(const gwt::PolygonOffset& o) {
    return {o.enable(), o.factor(), o.units()};
}

gwt::Jitter to_file(const JitterState& j) { return {j.x, j.y}; }
JitterState from_file(const gwt::Jitter& j) { return {j.x(), j.y()}; }

gwt::Lighting to_file(const LightingState& l) {
    return {l.local_viewer, l.two_side, to_file(l.model_ambient)};
}
LightingState from_file(const gwt::Lighting& l) {
    return {l.local_viewer(), l.two_side(), from_file(l.model_ambient())};
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
BlendState from_file(const gwt::Blend& b) {
    return {b.enable(), from_file(b.src()), from_file(b.dst())};
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

void read_clip_planes(const flatbuffers::Vector<const gwt::ClipPlane*>* planes, State& state) {
    if (!planes || planes->size() == 0) return;
    if (planes->size() != max_clip_planes)
        throw Error(
            fmt::format("{} clip planes in a state; expected {}", planes->size(), max_clip_planes));
    for (unsigned i = 0; i < planes->size(); ++i) state.clip_planes[i] = from_file(*planes->Get(i));
}

/// A group that is there.
template <typename File, typename Group>
void read(const File* stored, Group& group) {
    if (stored) group = from_file(*stored);
}

}  // namespace

flatbuffers::Offset<gwt::State> to_file(flatbuffers::FlatBufferBuilder& out, const State& s) {
    static const State initial;
    const auto planes = clip_planes_to_file(out, s);
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
    b.add_point_size(s.point_size);
    b.add_line_width(s.line_width);
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
    return b.Finish();
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
    s.point_size = f.point_size();
    s.line_width = f.line_width();
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
    return s;
}

}  // namespace gw::inspect
