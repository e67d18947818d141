// The fields of State, described once: text, differences, Python, recordings, the checks of SetState
// and the tables of docs/manual/state.md come from here. A member that is missing fails
// StateFields.AreAllMembers. Does not repeat initial values: gw/state.h has them.
#pragma once

#include "gw/describe/texture_state_fields.h"
#include "gw/state.h"

namespace gw {

// ---- Enumerations -------------------------------------------------------------------------------

template <>
inline constexpr auto sentence_of<CompareFunc> =
    "A comparison of the depth, stencil and alpha tests.";
template <>
inline constexpr auto sentence_of<StencilOp> = "An operation on a stencil value.";
template <>
inline constexpr auto sentence_of<BlendFactor> = "A factor of blending.";
template <>
inline constexpr auto sentence_of<BlendEquation> =
    "The combination of the two products in blending.";
template <>
inline constexpr auto sentence_of<LogicOp> = "glLogicOp's operations.";
template <>
inline constexpr auto sentence_of<DrawBuffer> = "The colour planes that fragments write to.";
template <>
inline constexpr auto sentence_of<ReadBuffer> = "The colour plane that copies and read-backs read.";
template <>
inline constexpr auto sentence_of<ClipOrigin> = "The corner of the window where y is -1.";
template <>
inline constexpr auto sentence_of<ClipDepth> = "The range of z / w in the view volume.";
template <>
inline constexpr auto sentence_of<Face> = "Sides of polygons.";
template <>
inline constexpr auto sentence_of<Winding> = "The order of a front face's corners in the window.";
template <>
inline constexpr auto sentence_of<PolygonMode> = "How polygons are drawn.";
template <>
inline constexpr auto sentence_of<ShadeModel> = "Shading of faces.";
template <>
inline constexpr auto sentence_of<ColorSource> = "The source of a primitive's colour.";
template <>
inline constexpr auto sentence_of<ColorMaterial> =
    "The material's parameters that follow the vertex colour.";
template <>
inline constexpr auto sentence_of<FogMode> = "The law of fog.";
template <>
inline constexpr auto sentence_of<FogCoordinate> = "Where the fog factor is computed.";
template <>
inline constexpr auto sentence_of<FogSource> = "The distance of fog.";

// ---- Transform, clipping and primitives ---------------------------------------------------------

template <>
inline constexpr auto sentence_of<ViewportState> = "Pixels; width and height 0: the whole window.";
template <>
inline constexpr auto fields_of<ViewportState> = std::tuple(
    field("x", &ViewportState::x, "R4.3", "Left pixel.", within(-4096, 4096)),
    field("y", &ViewportState::y, "R4.3", "Lower pixel.", within(-4096, 4096)),
    field("width", &ViewportState::width, "R4.3", "Pixels.",
          by_rule("both 0, or each 1 .. 4096, with surfaces 8192; 0: the window")),
    field("height", &ViewportState::height, "R4.3", "Pixels.", by_rule("as `viewport.width`")));

template <>
inline constexpr auto sentence_of<DepthRangeState> = "glDepthRange.";
template <>
inline constexpr auto fields_of<DepthRangeState> =
    std::tuple(field("near_value", &DepthRangeState::near_value, "R6.20", "0 .. 1."),
               field("far_value", &DepthRangeState::far_value, "R6.20", "0 .. 1."));

template <>
inline constexpr auto sentence_of<ClipControlState> = "Extension clip_control.";
template <>
inline constexpr auto fields_of<ClipControlState> =
    std::tuple(field("origin", &ClipControlState::origin, "R6.31", "Where y is -1.",
                     restricted("extension: UpperLeft")),
               field("depth", &ClipControlState::depth, "R6.32", "The range of z / w.",
                     restricted("extension: ZeroToOne")));

template <>
inline constexpr auto sentence_of<ClipPlane> = "Points with dot(plane, p_eye) >= 0 are kept.";
template <>
inline constexpr auto fields_of<ClipPlane> =
    std::tuple(field("enable", &ClipPlane::enable, "R6.10", "Whether it clips."),
               field("plane", &ClipPlane::plane, "R6.10", "In eye space."));

template <>
inline constexpr auto sentence_of<CullState> = "Culling of faces.";
template <>
inline constexpr auto fields_of<CullState> =
    std::tuple(field("enable", &CullState::enable, "R6.24", "Whether faces are culled."),
               field("face", &CullState::face, "R6.24", "The faces culled."),
               field("front", &CullState::front, "R6.23", "The winding of front faces."));

template <>
inline constexpr auto sentence_of<PolygonOffsetState> = "Extension polygon_offset.";
template <>
inline constexpr auto fields_of<PolygonOffsetState> =
    std::tuple(field("enable", &PolygonOffsetState::enable, "R9.12", "Of filled polygons.",
                     restricted("extension")),
               field("factor", &PolygonOffsetState::factor, "R9.12", "Of the slope."),
               field("units", &PolygonOffsetState::units, "R9.12", "Of the depth plane."),
               field("lines", &PolygonOffsetState::lines, "R9.22", "Of PolygonMode.Line.",
                     restricted("extension")),
               field("points", &PolygonOffsetState::points, "R9.22", "Of PolygonMode.Point.",
                     restricted("extension")));

template <>
inline constexpr auto sentence_of<JitterState> = "Moves every primitive by sub-pixel units [K4a].";
template <>
inline constexpr auto fields_of<JitterState> =
    std::tuple(field("x", &JitterState::x, "R6.22", "Sub-pixel units.", by_rule("-2^s < v < 2^s")),
               field("y", &JitterState::y, "R6.22", "Sub-pixel units.", by_rule("-2^s < v < 2^s")));

template <>
inline constexpr auto sentence_of<LineStippleState> = "Extension stipple.";
template <>
inline constexpr auto fields_of<LineStippleState> =
    std::tuple(field("enable", &LineStippleState::enable, "R9.20", "Whether lines are stippled.",
                     restricted("extension")),
               field("factor", &LineStippleState::factor, "R9.20", "1 .. 256.", within(1, 256)),
               field("pattern", &LineStippleState::pattern, "R9.20", "16 bits."));

template <>
inline constexpr auto sentence_of<PointParameters> = "Extension point_parameters.";
template <>
inline constexpr auto fields_of<PointParameters> = std::tuple(
    field("constant", &PointParameters::constant, "R9.31", "Of the distance's factor."),
    field("linear", &PointParameters::linear, "R9.31", "Times the distance."),
    field("quadratic", &PointParameters::quadratic, "R9.31", "Times its square."),
    field("min_size", &PointParameters::min_size, "R9.31", "Pixels, 1 .. 128.", within(1, 128)),
    field("max_size", &PointParameters::max_size, "R9.31", "Pixels, 1 .. 128.", within(1, 128)));

// ---- Colour, lighting and fog -------------------------------------------------------------------

template <>
inline constexpr auto sentence_of<ColorMaterialState> = "glColorMaterial.";
template <>
inline constexpr auto fields_of<ColorMaterialState> = std::tuple(
    field("enable", &ColorMaterialState::enable, "R8.10", "Whether parameters follow the colour."),
    field("face", &ColorMaterialState::face, "R8.10", "Of these sides."),
    field("mode", &ColorMaterialState::mode, "R8.10", "The parameters."));

template <>
inline constexpr auto sentence_of<LightingState> = "The lighting model.";
template <>
inline constexpr auto fields_of<LightingState> =
    std::tuple(field("local_viewer", &LightingState::local_viewer, "R8.6", "The eye is at 0."),
               field("two_side", &LightingState::two_side, "R8.8",
                     "Back faces are lit with reversed normals."),
               field("model_ambient", &LightingState::model_ambient, "R8.1", "R, G, B, A.",
                     restricted("finite; the last is unused")),
               field("color_material", &LightingState::color_material, "", "glColorMaterial."),
               field("separate_specular", &LightingState::separate_specular, "R8.11",
                     "Highlights are a secondary colour.", restricted("extension")));

template <>
inline constexpr auto sentence_of<FogState> = "glFog; distances in eye units.";
template <>
inline constexpr auto fields_of<FogState> = std::tuple(
    field("enable", &FogState::enable, "R11.1", "Whether there is fog."),
    field("mode", &FogState::mode, "R11.2", "Its law."),
    field("density", &FogState::density, "R11.2", "Of Exp and Exp2.", by_rule("> 0 if Exp, Exp2")),
    field("start", &FogState::start, "R11.2", "Of Linear.", by_rule("finite")),
    field("end", &FogState::end, "R11.2", "Of Linear.",
          by_rule("finite; not `fog.start` if Linear")),
    field("color", &FogState::color, "R11.1", "R, G, B, A.", by_rule("finite")),
    field("coordinate", &FogState::coordinate, "R11.4", "Where the factor is computed."),
    field("source", &FogState::source, "R11.8", "The distance.",
          restricted("extension: Coordinate")));

// ---- Fragments ----------------------------------------------------------------------------------

template <>
inline constexpr auto sentence_of<ScissorState> = "The scissor test.";
template <>
inline constexpr auto fields_of<ScissorState> =
    std::tuple(field("test", &ScissorState::test, "R4.4", "Whether it is on."),
               field("box", &ScissorState::box, "R4.4", "x, y, width, height.",
                     by_rule("width, height >= 0")));

template <>
inline constexpr auto sentence_of<AlphaState> = "The alpha test.";
template <>
inline constexpr auto fields_of<AlphaState> =
    std::tuple(field("test", &AlphaState::test, "R12.4", "Whether it is on."),
               field("func", &AlphaState::func, "R12.4", "The comparison."),
               field("ref", &AlphaState::ref, "R12.4", "0 .. 1."));

/// StencilState repeats the fields of StencilFace.
template <class Face>
inline constexpr auto stencil_face_fields = std::tuple(
    field("func", &Face::func, "R12.5", "The comparison."),
    field("ref", &Face::ref, "R12.5", "The reference value."),
    field("mask", &Face::mask, "R12.5", "Of the comparison."),
    field("fail", &Face::fail, "R12.6", "If the stencil test fails.",
          restricted("extension: wrapping")),
    field("zfail", &Face::zfail, "R12.6", "If the depth test fails.",
          restricted("extension: wrapping")),
    field("zpass", &Face::zpass, "R12.6", "If both pass.", restricted("extension: wrapping")),
    field("write_mask", &Face::write_mask, "R12.7", "Of the plane."));

template <>
inline constexpr auto sentence_of<StencilFace> = "The stencil test of back faces.";
template <>
inline constexpr auto fields_of<StencilFace> = stencil_face_fields<StencilFace>;
template <>
inline constexpr auto sentence_of<StencilState> = "The stencil test.";
template <>
inline constexpr auto fields_of<StencilState> = std::tuple_cat(
    std::tuple(field("test", &StencilState::test, "R12.5", "Whether it is on.")),
    stencil_face_fields<StencilState>,
    std::tuple(field("two_side", &StencilState::two_side, "R12.8",
                     "Back faces have a test of their own.", restricted("extension")),
               field("back", &StencilState::back, "", "That test.")));

template <>
inline constexpr auto sentence_of<DepthState> = "The depth test.";
template <>
inline constexpr auto fields_of<DepthState> =
    std::tuple(field("test", &DepthState::test, "R12.9", "Whether it is on."),
               field("func", &DepthState::func, "R12.9", "The comparison."),
               field("mask", &DepthState::mask, "R12.9", "Whether depths are written."));

/// BlendState has them for colours, BlendAlphaState for alpha.
template <class Blend>
inline constexpr auto blend_factor_fields = std::tuple(
    field("src", &Blend::src, "R12.12", "Factor of the fragment.",
          restricted("without `blend_square` not SrcColor, OneMinusSrcColor")),
    field(
        "dst", &Blend::dst, "R12.12", "Factor of the plane.",
        restricted("not SrcAlphaSaturate; without `blend_square` not DstColor, OneMinusDstColor")),
    field("equation", &Blend::equation, "R12.14", "Their combination.", restricted("extensions")));

template <>
inline constexpr auto sentence_of<BlendAlphaState> = "Extension blend_separate.";
template <>
inline constexpr auto fields_of<BlendAlphaState> =
    std::tuple_cat(std::tuple(field("separate", &BlendAlphaState::separate, "R12.17",
                                    "Alpha is blended by these.", restricted("extension"))),
                   blend_factor_fields<BlendAlphaState>);
template <>
inline constexpr auto sentence_of<BlendState> = "Blending.";
template <>
inline constexpr auto fields_of<BlendState> = std::tuple_cat(
    std::tuple(field("enable", &BlendState::enable, "R12.11", "Whether it is on.")),
    blend_factor_fields<BlendState>,
    std::tuple(field("color", &BlendState::color, "R12.12", "Of the constant factors."),
               field("alpha", &BlendState::alpha, "", "Of alpha.")));

template <>
inline constexpr auto sentence_of<MultisampleState> =
    "Extension multisample, on surfaces with samples.";
template <>
inline constexpr auto fields_of<MultisampleState> = std::tuple(
    field("enable", &MultisampleState::enable, "R17.2", "Samples have places of their own."),
    field("alpha_to_coverage", &MultisampleState::alpha_to_coverage, "R17.4",
          "Alpha says how many samples stay.", restricted("extension")),
    field("alpha_to_one", &MultisampleState::alpha_to_one, "R17.4", "Alpha is one after that.",
          restricted("extension")),
    field("coverage_test", &MultisampleState::coverage_test, "R17.4",
          "A part of the samples stays.", restricted("extension")),
    field("coverage", &MultisampleState::coverage, "R17.4", "That part, clamped to 0 .. 1."),
    field("invert", &MultisampleState::invert, "R17.4", "The others stay."));

template <>
inline constexpr auto sentence_of<LogicOpState> = "Extension logic_op.";
template <>
inline constexpr auto fields_of<LogicOpState> = std::tuple(
    field("enable", &LogicOpState::enable, "R12.15", "Whether it is on.", restricted("extension")),
    field("op", &LogicOpState::op, "R12.15", "The operation."));

template <>
inline constexpr auto sentence_of<ColorMask> = "The channels that are written.";
template <>
inline constexpr auto fields_of<ColorMask> = std::tuple(
    field("r", &ColorMask::r, "R12.13", "Red."), field("g", &ColorMask::g, "R12.13", "Green."),
    field("b", &ColorMask::b, "R12.13", "Blue."), field("a", &ColorMask::a, "R12.13", "Alpha."));
template <>
inline constexpr auto sentence_of<ColorMaskBits> = "The bits of channels that are written.";
template <>
inline constexpr auto fields_of<ColorMaskBits> =
    std::tuple(field("r", &ColorMaskBits::r, "R12.19", "Of red."),
               field("g", &ColorMaskBits::g, "R12.19", "Of green."),
               field("b", &ColorMaskBits::b, "R12.19", "Of blue."),
               field("a", &ColorMaskBits::a, "R12.19", "Of alpha."));

// ---- The whole state ----------------------------------------------------------------------------

template <>
inline constexpr auto sentence_of<State> =
    "The whole state of the pipeline, with OpenGL's initial values.";
template <>
inline constexpr auto fields_of<State> = std::tuple(
    field("projection", &State::projection, "R6.9", "clip_from_eye, M[row, column]."),
    field("normalize", &State::normalize, "R6.28", "Normals have length 1 after the transform."),
    field("viewport", &State::viewport, "", "In pixels."),
    field("depth_range", &State::depth_range, "", "glDepthRange."),
    field("clip_control", &State::clip_control, "", "Extension clip_control."),
    field("clip_planes", &State::clip_planes, "", "Six planes in eye space."),
    field("cull", &State::cull, "", "Culling."),
    field("polygon_mode", &State::polygon_mode, "R6.7", "Of front faces, or of all."),
    field("polygon_offset", &State::polygon_offset, "", "Extension polygon_offset."),
    field("two_side_polygon_mode", &State::two_side_polygon_mode, "R6.30",
          "Back faces have their own.", restricted("extension")),
    field("back_polygon_mode", &State::back_polygon_mode, "R6.30", "Of back faces."),
    field("line_stipple", &State::line_stipple, "", "Extension stipple."),
    field("polygon_stipple", &State::polygon_stipple, "R9.21", "32 words, a row each; None: off.",
          restricted("extension")),
    field("jitter", &State::jitter, "", "Sub-pixel displacement."),
    field("point_size", &State::point_size, "R9.5, R9.27", "Pixels, 1 .. 128.", within(1, 128)),
    field("point_parameters", &State::point_parameters, "", "Sizes by distance."),
    field("point_sprite", &State::point_sprite, "R9.32", "Points are squares with a texture.",
          restricted("extension")),
    field("line_width", &State::line_width, "R9.4, R9.26", "Pixels, 1 .. 128.", within(1, 128)),
    field("diamond_lines", &State::diamond_lines, "R9.34", "Lines by the diamond rule."),
    field("point_smooth", &State::point_smooth, "R9.23", "Antialiased points.",
          restricted("extension `antialiasing`")),
    field("line_smooth", &State::line_smooth, "R9.23", "Antialiased lines.",
          restricted("extension `antialiasing`")),
    field("polygon_smooth", &State::polygon_smooth, "R9.23", "Antialiased polygons.",
          restricted("extension `antialiasing`")),
    field("shade_model", &State::shade_model, "R6.6", "Flat or smooth."),
    field("color_source", &State::color_source, "R6.12", "Vertices, lighting or identifiers."),
    field("lighting", &State::lighting, "", "The lighting model."),
    field("color_sum", &State::color_sum, "R8.13", "The secondary colour is added.",
          restricted("extension")),
    field("fog", &State::fog, "", "Fog."),
    field("texture", &State::texture, "", "How texels are used."),
    field("more_textures", &State::more_textures, "R10.37",
          "How units 1 to 3 use texels; None: their initial states.", restricted("extension")),
    field("scissor", &State::scissor, "", "The scissor test."),
    field("alpha", &State::alpha, "", "The alpha test."),
    field("stencil", &State::stencil, "", "The stencil test."),
    field("depth", &State::depth, "", "The depth test."),
    field("blend", &State::blend, "", "Blending."),
    field("logic_op", &State::logic_op, "", "Logical operations."),
    field("color_mask", &State::color_mask, "", "Channels that are written."),
    field("color_mask_bits", &State::color_mask_bits, "", "Bits of them."),
    field("multisample", &State::multisample, "", "Samples of fragments."),
    field("draw_buffer", &State::draw_buffer, "R12.16", "Planes that are written.",
          restricted("Back, FrontAndBack: two colour planes")),
    field("read_buffer", &State::read_buffer, "R13.17", "The plane that is read.",
          restricted("Back: two colour planes")));

}  // namespace gw
