// Enumerations, profiles and the pipeline's state.
#include "gw/state.h"

#include "gw/command_list.h"
#include "gw/profile.h"
#include "gw/profile_text.h"
#include "python/binding/fields.h"
#include "python/binding/module.h"

namespace gw::python {
namespace {

void add_test_enums(py::module_& m) {
    add_enum<Plane>(m, "Plane", "A plane of the machine.",
                    {{"Color", Plane::Color},
                     {"Depth", Plane::Depth},
                     {"Stencil", Plane::Stencil},
                     {"Accum", Plane::Accum},
                     {"Back", Plane::Back}});
    using C = CompareFunc;
    add_enum<C>(m, "CompareFunc", "A comparison of the depth, stencil and alpha tests.",
                {{"Never", C::Never},
                 {"Less", C::Less},
                 {"Equal", C::Equal},
                 {"LEqual", C::LEqual},
                 {"Greater", C::Greater},
                 {"NotEqual", C::NotEqual},
                 {"GEqual", C::GEqual},
                 {"Always", C::Always}});
    using S = StencilOp;
    add_enum<S>(m, "StencilOp", "An operation on a stencil value.",
                {{"Keep", S::Keep},
                 {"Zero", S::Zero},
                 {"Replace", S::Replace},
                 {"Incr", S::Incr},
                 {"Decr", S::Decr},
                 {"Invert", S::Invert},
                 {"IncrWrap", S::IncrWrap},
                 {"DecrWrap", S::DecrWrap}});
    using B = BlendFactor;
    add_enum<B>(m, "BlendFactor", "A factor of blending.",
                {{"Zero", B::Zero},
                 {"One", B::One},
                 {"SrcColor", B::SrcColor},
                 {"OneMinusSrcColor", B::OneMinusSrcColor},
                 {"DstColor", B::DstColor},
                 {"OneMinusDstColor", B::OneMinusDstColor},
                 {"SrcAlpha", B::SrcAlpha},
                 {"OneMinusSrcAlpha", B::OneMinusSrcAlpha},
                 {"DstAlpha", B::DstAlpha},
                 {"OneMinusDstAlpha", B::OneMinusDstAlpha},
                 {"SrcAlphaSaturate", B::SrcAlphaSaturate},
                 {"ConstantColor", B::ConstantColor},
                 {"OneMinusConstantColor", B::OneMinusConstantColor},
                 {"ConstantAlpha", B::ConstantAlpha},
                 {"OneMinusConstantAlpha", B::OneMinusConstantAlpha}});
    using E = BlendEquation;
    add_enum<E>(m, "BlendEquation", "The combination of the two products in blending.",
                {{"Add", E::Add},
                 {"Subtract", E::Subtract},
                 {"ReverseSubtract", E::ReverseSubtract},
                 {"Min", E::Min},
                 {"Max", E::Max}});
    using L = LogicOp;
    add_enum<L>(m, "LogicOp", "glLogicOp's operations.",
                {{"Clear", L::Clear},
                 {"And", L::And},
                 {"AndReverse", L::AndReverse},
                 {"Copy", L::Copy},
                 {"AndInverted", L::AndInverted},
                 {"Noop", L::Noop},
                 {"Xor", L::Xor},
                 {"Or", L::Or},
                 {"Nor", L::Nor},
                 {"Equiv", L::Equiv},
                 {"Invert", L::Invert},
                 {"OrReverse", L::OrReverse},
                 {"CopyInverted", L::CopyInverted},
                 {"OrInverted", L::OrInverted},
                 {"Nand", L::Nand},
                 {"Set", L::Set}});
    add_enum<DrawBuffer>(m, "DrawBuffer", "The colour planes that fragments write to.",
                         {{"NoBuffer", DrawBuffer::None},
                          {"Front", DrawBuffer::Front},
                          {"Back", DrawBuffer::Back},
                          {"FrontAndBack", DrawBuffer::FrontAndBack}});
    add_enum<ReadBuffer>(m, "ReadBuffer", "The colour plane that copies and read-backs read.",
                         {{"Front", ReadBuffer::Front}, {"Back", ReadBuffer::Back}});
}

void add_drawing_enums(py::module_& m) {
    add_enum<Face>(
        m, "Face", "Sides of polygons.",
        {{"Front", Face::Front}, {"Back", Face::Back}, {"FrontAndBack", Face::FrontAndBack}});
    add_enum<Winding>(m, "Winding", "The order of a front face's corners in the window.",
                      {{"CW", Winding::CW}, {"CCW", Winding::CCW}});
    add_enum<PolygonMode>(
        m, "PolygonMode", "How polygons are drawn.",
        {{"Point", PolygonMode::Point}, {"Line", PolygonMode::Line}, {"Fill", PolygonMode::Fill}});
    add_enum<ShadeModel>(m, "ShadeModel", "Shading of faces.",
                         {{"Flat", ShadeModel::Flat}, {"Smooth", ShadeModel::Smooth}});
    add_enum<ColorSource>(m, "ColorSource", "The source of a primitive's colour.",
                          {{"Vertex", ColorSource::Vertex},
                           {"Lighting", ColorSource::Lighting},
                           {"PolygonId", ColorSource::PolygonId}});
    using M = ColorMaterial;
    add_enum<M>(m, "ColorMaterial", "The material's parameters that follow the vertex colour.",
                {{"Emission", M::Emission},
                 {"Ambient", M::Ambient},
                 {"Diffuse", M::Diffuse},
                 {"Specular", M::Specular},
                 {"AmbientAndDiffuse", M::AmbientAndDiffuse}});
    add_enum<FogMode>(
        m, "FogMode", "The law of fog.",
        {{"Linear", FogMode::Linear}, {"Exp", FogMode::Exp}, {"Exp2", FogMode::Exp2}});
    add_enum<FogCoordinate>(m, "FogCoordinate", "Where the fog factor is computed.",
                            {{"Profile", FogCoordinate::Profile},
                             {"Vertex", FogCoordinate::Vertex},
                             {"Fragment", FogCoordinate::Fragment}});
    using F = MinFilter;
    add_enum<F>(m, "MinFilter", "The minification filter.",
                {{"Nearest", F::Nearest},
                 {"Linear", F::Linear},
                 {"NearestMipmapNearest", F::NearestMipmapNearest},
                 {"LinearMipmapNearest", F::LinearMipmapNearest},
                 {"NearestMipmapLinear", F::NearestMipmapLinear},
                 {"LinearMipmapLinear", F::LinearMipmapLinear}});
    add_enum<MagFilter>(m, "MagFilter", "The magnification filter.",
                        {{"Nearest", MagFilter::Nearest}, {"Linear", MagFilter::Linear}});
    add_enum<Wrap>(
        m, "Wrap", "Texture coordinates outside 0 .. 1.",
        {{"Repeat", Wrap::Repeat}, {"Clamp", Wrap::Clamp}, {"BorderClamp", Wrap::BorderClamp}});
    add_enum<TexEnv>(m, "TexEnv", "How a texel changes the colour.",
                     {{"Modulate", TexEnv::Modulate},
                      {"Decal", TexEnv::Decal},
                      {"Blend", TexEnv::Blend},
                      {"Replace", TexEnv::Replace}});
    add_enum<TexGen>(m, "TexGen", "Generated texture coordinates.",
                     {{"Off", TexGen::None},
                      {"SphereMap", TexGen::SphereMap},
                      {"RefractionMap", TexGen::RefractionMap},
                      {"EyeLinear", TexGen::EyeLinear},
                      {"PerCoordinate", TexGen::PerCoordinate}});
    using G = CoordinateMode;
    add_enum<G>(m, "CoordinateMode", "The rule of one texture coordinate.",
                {{"Given", G::Given},
                 {"ObjectLinear", G::ObjectLinear},
                 {"EyeLinear", G::EyeLinear},
                 {"SphereMap", G::SphereMap}});
    using A = AccumOp;
    add_enum<A>(m, "AccumOp", "An operation on the accumulation buffer.",
                {{"Accum", A::Accum},
                 {"Load", A::Load},
                 {"Add", A::Add},
                 {"Mult", A::Mult},
                 {"Return", A::Return}});
}

void add_profiles(py::module_& m) {
    Fields<Extensions> extensions(m, "Extensions", "Features that a machine may lack.");
    for (const ExtensionName& name : extension_names())
        extensions.field(name.name, name.member, "Whether the machine has it.");
    Fields<Profile> profile(m, "Profile", "A machine's bits of each value, and its extensions.");
    profile.field("name", &Profile::name, "For messages.")
        .field("color_bits", &Profile::color_bits, "Per channel, 8 .. 16.")
        .field("depth_bits", &Profile::depth_bits, "16 .. 32.")
        .field("stencil_bits", &Profile::stencil_bits, "1 .. 8.")
        .field("accum_bits", &Profile::accum_bits, "Per channel, signed, 16 .. 32.")
        .field("subpixel_bits", &Profile::subpixel_bits, "1 .. 8.")
        .field("lit_bits", &Profile::lit_bits, "Of a lit vertex colour, 4 .. color_bits.")
        .field("max_lights", &Profile::max_lights, "In one pass, 1 .. 1024.")
        .field("texel_bits", &Profile::texel_bits, "Of a texel's channel; 0: color_bits.")
        .field("coverage_bits", &Profile::coverage_bits, "Of antialiasing; 0: none.")
        .field("color_planes", &Profile::color_planes, "2: front and back.")
        .field("fragment_fog", &Profile::fragment_fog, "Fog at each fragment by default.")
        .field("perspective_color", &Profile::perspective_color, "Gouraud shading in perspective.")
        .field("extensions", &Profile::extensions, "The features that it has.");
    profile.type().def(py::init([](const std::string& text) { return profile_from_text(text); }),
                       py::arg("text"),
                       "A built-in profile with changes: \"vgx\", \"opengl,depth_bits=32\".");
    profile.type().def("__str__", [](const Profile& p) { return profile_text(p); });
    py::implicitly_convertible<py::str, Profile>();
    m.def("profiles", &profiles, "The built-in profiles: vgx, reality, ideal, opengl.");
}

void add_geometry_state(py::module_& m) {
    Fields<ViewportState>(m, "ViewportState", "Pixels; width and height 0: the whole window.")
        .field("x", &ViewportState::x, "Left pixel.")
        .field("y", &ViewportState::y, "Lower pixel.")
        .field("width", &ViewportState::width, "Pixels.")
        .field("height", &ViewportState::height, "Pixels.");
    Fields<DepthRangeState>(m, "DepthRangeState", "glDepthRange.")
        .field("near_value", &DepthRangeState::near_value, "0 .. 1.")
        .field("far_value", &DepthRangeState::far_value, "0 .. 1.");
    Fields<ClipPlane>(m, "ClipPlane", "Points with dot(plane, p_eye) >= 0 are kept.")
        .field("enable", &ClipPlane::enable, "Whether it clips.")
        .field("plane", &ClipPlane::plane, "In eye space.");
    Fields<CullState>(m, "CullState", "Culling of faces.")
        .field("enable", &CullState::enable, "Whether faces are culled.")
        .field("face", &CullState::face, "The faces culled.")
        .field("front", &CullState::front, "The winding of front faces.");
    Fields<PolygonOffsetState>(m, "PolygonOffsetState", "Extension polygon_offset.")
        .field("enable", &PolygonOffsetState::enable, "Of filled polygons.")
        .field("factor", &PolygonOffsetState::factor, "Of the slope.")
        .field("units", &PolygonOffsetState::units, "Of the depth plane.")
        .field("lines", &PolygonOffsetState::lines, "Of PolygonMode.Line.")
        .field("points", &PolygonOffsetState::points, "Of PolygonMode.Point.");
    Fields<JitterState>(m, "JitterState", "Moves every primitive by sub-pixel units [K4a].")
        .field("x", &JitterState::x, "Sub-pixel units.")
        .field("y", &JitterState::y, "Sub-pixel units.");
    Fields<LineStippleState>(m, "LineStippleState", "Extension stipple.")
        .field("enable", &LineStippleState::enable, "Whether lines are stippled.")
        .field("factor", &LineStippleState::factor, "1 .. 256.")
        .field("pattern", &LineStippleState::pattern, "16 bits.");
    Fields<ColorMaterialState>(m, "ColorMaterialState", "glColorMaterial.")
        .field("enable", &ColorMaterialState::enable, "Whether parameters follow the colour.")
        .field("face", &ColorMaterialState::face, "Of these sides.")
        .field("mode", &ColorMaterialState::mode, "The parameters.");
    Fields<LightingState>(m, "LightingState", "The lighting model.")
        .field("local_viewer", &LightingState::local_viewer, "The eye is at 0.")
        .field("two_side", &LightingState::two_side, "Back faces are lit with reversed normals.")
        .field("model_ambient", &LightingState::model_ambient, "R, G, B, A.")
        .field("color_material", &LightingState::color_material, "glColorMaterial.");
}

void add_texture_state(py::module_& m) {
    Fields<FogState>(m, "FogState", "glFog; distances in eye units.")
        .field("enable", &FogState::enable, "Whether there is fog.")
        .field("mode", &FogState::mode, "Its law.")
        .field("density", &FogState::density, "Of Exp and Exp2.")
        .field("start", &FogState::start, "Of Linear.")
        .field("end", &FogState::end, "Of Linear.")
        .field("color", &FogState::color, "R, G, B, A.")
        .field("coordinate", &FogState::coordinate, "Where the factor is computed.");
    Fields<CoordinateGen>(m, "CoordinateGen", "The rule of one texture coordinate.")
        .field("mode", &CoordinateGen::mode, "The rule.")
        .field("plane", &CoordinateGen::plane, "Of linear rules.");
    Fields<TextureState>(m, "TextureState", "How texels are used.")
        .field("min_filter", &TextureState::min_filter, "Minification.")
        .field("mag_filter", &TextureState::mag_filter, "Magnification.")
        .field("wrap_s", &TextureState::wrap_s, "Of s.")
        .field("wrap_t", &TextureState::wrap_t, "Of t.")
        .field("env", &TextureState::env, "How a texel changes the colour.")
        .field("env_color", &TextureState::env_color, "Of TexEnv.Blend.")
        .field("gen", &TextureState::gen, "Generated coordinates.")
        .field("eta", &TextureState::eta, "n1 / n2 of RefractionMap.")
        .field("eye_linear", &TextureState::eye_linear, "Rows give s, t, r, q.")
        .field("coordinates", &TextureState::coordinates, "Of PerCoordinate: s, t, r, q.")
        .field("matrix", &TextureState::matrix, "Applied to texture coordinates.")
        .field("border_color", &TextureState::border_color, "Of BorderClamp.")
        .field("shadow_compare", &TextureState::shadow_compare, "1 if r <= texel, else 0.");
}

void add_fragment_state(py::module_& m) {
    Fields<ScissorState>(m, "ScissorState", "The scissor test.")
        .field("test", &ScissorState::test, "Whether it is on.")
        .field("box", &ScissorState::box, "x, y, width, height.");
    Fields<AlphaState>(m, "AlphaState", "The alpha test.")
        .field("test", &AlphaState::test, "Whether it is on.")
        .field("func", &AlphaState::func, "The comparison.")
        .field("ref", &AlphaState::ref, "0 .. 1.");
    Fields<StencilFace>(m, "StencilFace", "The stencil test of back faces.")
        .field("func", &StencilFace::func, "The comparison.")
        .field("ref", &StencilFace::ref, "The reference value.")
        .field("mask", &StencilFace::mask, "Of the comparison.")
        .field("fail", &StencilFace::fail, "If the stencil test fails.")
        .field("zfail", &StencilFace::zfail, "If the depth test fails.")
        .field("zpass", &StencilFace::zpass, "If both pass.")
        .field("write_mask", &StencilFace::write_mask, "Of the plane.");
    Fields<StencilState>(m, "StencilState", "The stencil test.")
        .field("test", &StencilState::test, "Whether it is on.")
        .field("func", &StencilState::func, "The comparison.")
        .field("ref", &StencilState::ref, "The reference value.")
        .field("mask", &StencilState::mask, "Of the comparison.")
        .field("fail", &StencilState::fail, "If the stencil test fails.")
        .field("zfail", &StencilState::zfail, "If the depth test fails.")
        .field("zpass", &StencilState::zpass, "If both pass.")
        .field("write_mask", &StencilState::write_mask, "Of the plane.")
        .field("two_side", &StencilState::two_side, "Back faces have a test of their own.")
        .field("back", &StencilState::back, "That test.");
    Fields<DepthState>(m, "DepthState", "The depth test.")
        .field("test", &DepthState::test, "Whether it is on.")
        .field("func", &DepthState::func, "The comparison.")
        .field("mask", &DepthState::mask, "Whether depths are written.");
    Fields<BlendState>(m, "BlendState", "Blending.")
        .field("enable", &BlendState::enable, "Whether it is on.")
        .field("src", &BlendState::src, "Factor of the fragment.")
        .field("dst", &BlendState::dst, "Factor of the plane.")
        .field("equation", &BlendState::equation, "Their combination.")
        .field("color", &BlendState::color, "Of the constant factors.");
    Fields<LogicOpState>(m, "LogicOpState", "Extension logic_op.")
        .field("enable", &LogicOpState::enable, "Whether it is on.")
        .field("op", &LogicOpState::op, "The operation.");
    Fields<ColorMask>(m, "ColorMask", "The channels that are written.")
        .field("r", &ColorMask::r, "Red.")
        .field("g", &ColorMask::g, "Green.")
        .field("b", &ColorMask::b, "Blue.")
        .field("a", &ColorMask::a, "Alpha.");
}

using StipplePattern = std::array<std::uint32_t, 32>;

void add_whole_state(py::module_& m) {
    Fields<State> state(m, "State",
                        "The whole state of the pipeline, with OpenGL's initial values.");
    state.field("projection", &State::projection, "clip_from_eye, M[row, column].")
        .field("normalize", &State::normalize, "Normals have length 1 after the transform.")
        .field("viewport", &State::viewport, "In pixels.")
        .field("depth_range", &State::depth_range, "glDepthRange.")
        .field("clip_planes", &State::clip_planes, "Six planes in eye space.")
        .field("cull", &State::cull, "Culling.")
        .field("polygon_mode", &State::polygon_mode, "Of front faces, or of all.")
        .field("two_side_polygon_mode", &State::two_side_polygon_mode, "Back faces have their own.")
        .field("back_polygon_mode", &State::back_polygon_mode, "Of back faces.")
        .field("line_stipple", &State::line_stipple, "Extension stipple.")
        .property(
            "polygon_stipple",
            [](const State& s) -> std::optional<StipplePattern> {
                if (!s.polygon_stipple.pattern) return {};
                return *s.polygon_stipple.pattern;
            },
            [](State& s, const std::optional<StipplePattern>& pattern) {
                s.polygon_stipple.pattern =
                    pattern ? std::make_shared<const StipplePattern>(*pattern) : nullptr;
            },
            "32 words, a row each; None: off.")
        .field("polygon_offset", &State::polygon_offset, "Extension polygon_offset.")
        .field("jitter", &State::jitter, "Sub-pixel displacement.")
        .field("point_size", &State::point_size, "Pixels, 1 .. 128.")
        .field("line_width", &State::line_width, "Pixels, 1 .. 128.")
        .field("point_smooth", &State::point_smooth, "Antialiased points.")
        .field("line_smooth", &State::line_smooth, "Antialiased lines.")
        .field("polygon_smooth", &State::polygon_smooth, "Antialiased polygons.")
        .field("shade_model", &State::shade_model, "Flat or smooth.")
        .field("color_source", &State::color_source, "Vertices, lighting or identifiers.")
        .field("lighting", &State::lighting, "The lighting model.")
        .field("fog", &State::fog, "Fog.")
        .field("texture", &State::texture, "How texels are used.")
        .field("scissor", &State::scissor, "The scissor test.")
        .field("alpha", &State::alpha, "The alpha test.")
        .field("stencil", &State::stencil, "The stencil test.")
        .field("depth", &State::depth, "The depth test.")
        .field("blend", &State::blend, "Blending.")
        .field("logic_op", &State::logic_op, "Logical operations.")
        .field("color_mask", &State::color_mask, "Channels that are written.")
        .field("draw_buffer", &State::draw_buffer, "Planes that are written.")
        .field("read_buffer", &State::read_buffer, "The plane that is read.");
}

}  // namespace

void add_state(py::module_& module) {
    add_test_enums(module);
    add_drawing_enums(module);
    add_profiles(module);
    add_geometry_state(module);
    add_texture_state(module);
    add_fragment_state(module);
    add_whole_state(module);
}

}  // namespace gw::python
