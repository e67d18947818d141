// The fields of TextureState: a part of gw/describe/state_fields.h.
#pragma once

#include "gw/describe/fields.h"
#include "gw/texture_state.h"

namespace gw {

template <>
inline constexpr auto sentence_of<MinFilter> = "The minification filter.";
template <>
inline constexpr auto sentence_of<MagFilter> = "The magnification filter.";
template <>
inline constexpr auto sentence_of<Wrap> = "Texture coordinates outside 0 .. 1.";
template <>
inline constexpr auto sentence_of<TexEnv> = "How a texel changes the colour.";
template <>
inline constexpr auto sentence_of<CombineFunc> = "A function of TexEnv.Combine.";
template <>
inline constexpr auto sentence_of<CombineSource> = "Where an argument's value is from.";
template <>
inline constexpr auto sentence_of<CombineOperand> = "What an argument takes of its source.";
template <>
inline constexpr auto sentence_of<TexGen> = "Generated texture coordinates.";
template <>
inline constexpr auto sentence_of<CoordinateMode> = "The rule of one texture coordinate.";

template <>
inline constexpr auto sentence_of<CoordinateGen> = "The rule of one texture coordinate.";
template <>
inline constexpr auto fields_of<CoordinateGen> = std::tuple(
    field("mode", &CoordinateGen::mode, "R10.20", "The rule.",
          restricted("SphereMap: of s and t; extension: NormalMap, ReflectionMap, not of q")),
    field("plane", &CoordinateGen::plane, "R10.20", "Of linear rules."));

template <>
inline constexpr auto sentence_of<TextureLodState> = "Extension texture_lod.";
template <>
inline constexpr auto fields_of<TextureLodState> = std::tuple(
    field("base_level", &TextureLodState::base_level, "R10.31", "The first.", within(0, 1000)),
    field("max_level", &TextureLodState::max_level, "R10.31", "The last.", within(0, 1000)),
    field("bias", &TextureLodState::bias, "R10.31", "Added to the level of detail."),
    field("min", &TextureLodState::min, "R10.31", "The least level of detail."),
    field("max", &TextureLodState::max, "R10.31", "The greatest level of detail."));

template <>
inline constexpr auto sentence_of<CombineState> = "A function of up to three arguments.";
template <>
inline constexpr auto fields_of<CombineState> =
    std::tuple(field("func", &CombineState::func, "R10.34", "The function.",
                     restricted("alpha: not Dot3Rgb, Dot3Rgba")),
               field("source0", &CombineState::source0, "R10.33", "Of the first argument.",
                     restricted("extension: Texture0 .. 3")),
               field("source1", &CombineState::source1, "R10.33", "Of the second argument.",
                     restricted("extension: Texture0 .. 3")),
               field("source2", &CombineState::source2, "R10.33", "Of the third argument.",
                     restricted("extension: Texture0 .. 3")),
               field("operand0", &CombineState::operand0, "R10.33", "Of the first argument."),
               field("operand1", &CombineState::operand1, "R10.33", "Of the second argument."),
               field("operand2", &CombineState::operand2, "R10.33", "Of the third argument."),
               field("scale", &CombineState::scale, "R10.35", "1, 2 or 4.", by_rule("1, 2 or 4")));

template <>
inline constexpr auto sentence_of<TextureState> = "How texels are used.";
template <>
inline constexpr auto fields_of<TextureState> = std::tuple(
    field("min_filter", &TextureState::min_filter, "R10.13", "Minification."),
    field("mag_filter", &TextureState::mag_filter, "R10.13", "Magnification."),
    field("wrap_s", &TextureState::wrap_s, "R10.9", "Of s.", restricted("extensions")),
    field("wrap_t", &TextureState::wrap_t, "R10.9", "Of t.", restricted("extensions")),
    field("env", &TextureState::env, "R10.17", "How a texel changes the colour.",
          restricted("extension: Add, Combine")),
    field("env_color", &TextureState::env_color, "R10.17", "Of TexEnv.Blend, Combine."),
    field("gen", &TextureState::gen, "R10.1", "Generated coordinates."),
    field("eta", &TextureState::eta, "R10.3", "n1 / n2 of RefractionMap."),
    field("eye_linear", &TextureState::eye_linear, "R10.4", "Rows give s, t, r, q."),
    field("coordinates", &TextureState::coordinates, "", "Of PerCoordinate: s, t, r, q."),
    field("matrix", &TextureState::matrix, "R10.21", "Applied to texture coordinates."),
    field("border_color", &TextureState::border_color, "R10.25", "Of BorderClamp, ClampToBorder."),
    field("shadow_compare", &TextureState::shadow_compare, "R10.18", "1 if r <= texel, else 0.",
          restricted("extension")),
    field("compare_func", &TextureState::compare_func, "R10.41", "Of r and texel.",
          restricted("extension")),
    field("wrap_r", &TextureState::wrap_r, "R10.45", "Of r.", restricted("extensions")),
    field("seamless", &TextureState::seamless, "R10.44", "Filters reach over a cube's edges.",
          restricted("extension")),
    field("lod", &TextureState::lod, "", "The levels that are used."),
    field("combine_rgb", &TextureState::combine_rgb, "", "Of TexEnv.Combine: colours."),
    field("combine_alpha", &TextureState::combine_alpha, "", "Of TexEnv.Combine: alpha."),
    field("exact_rho", &TextureState::exact_rho, "R10.46", "rho by lengths."),
    field("coord_replace", &TextureState::coord_replace, "R9.32", "s and t of point sprites.",
          restricted("extension")));

}  // namespace gw
