// Checks SetState: extensions; every field by its type and range (gw/describe/state_fields.h); rules
// of single fields.
#include "gw/describe/opengl.h"
#include "gw/describe/state_fields.h"
#include "gw/validate/checker.h"

#include <type_traits>

namespace gw {
namespace {

/// The extension that brings a word.
template <class Enum>
void check_word(const Checker& c, Enum value) {
    const Extensions& present = c.profile.extensions;
    if (value > last_of<Enum> || has_word(present, value)) return;
    for (const ExtensionName& extension : extension_names())
        if (extension.member == opengl_word(value).extension)
            c.extension(true, false, extension.name);
}
void check_words(const Checker& c, const auto& stencil_face) {
    check_word(c, stencil_face.fail);
    check_word(c, stencil_face.zfail);
    check_word(c, stencil_face.zpass);
}
void check_words(const Checker& c, const BlendState& b) {
    if (!b.enable) return;
    check_word(c, b.src);
    check_word(c, b.dst);
    check_word(c, b.equation);
    if (!b.alpha.separate) return;
    c.extension(true, c.profile.extensions.blend_separate, "blend_separate");
    check_word(c, b.alpha.src);
    check_word(c, b.alpha.dst);
    check_word(c, b.alpha.equation);
}

void check_words(const Checker& c, const CombineState& s) {
    check_word(c, s.source0);
    check_word(c, s.source1);
    check_word(c, s.source2);
}
void check_extensions(const Checker& c, const TextureState& s) {
    const Extensions& e = c.profile.extensions;
    check_word(c, s.wrap_s);
    check_word(c, s.wrap_t);
    check_word(c, s.wrap_r);
    check_word(c, s.env);
    check_words(c, s.combine_rgb);
    check_words(c, s.combine_alpha);
    for (const CoordinateGen& rule : s.coordinates)
        c.extension(rule.mode >= CoordinateMode::NormalMap && rule.mode <= last_of<CoordinateMode>,
                    e.texture_cube, "texture_cube");
    c.extension(s.lod != TextureLodState{}, e.texture_lod, "texture_lod");
    c.extension(s.shadow_compare, e.shadow_texture || e.texture_depth, "shadow_texture");
    c.extension(s.compare_func != CompareFunc::LEqual, e.texture_depth, "texture_depth");
    c.extension(s.wrap_r != Wrap::Repeat, e.texture_3d, "texture_3d");
    c.extension(s.coord_replace, e.point_sprite, "point_sprite");
    c.extension(s.seamless, e.texture_seamless, "texture_seamless");
}

void check_extensions(const Checker& c, const State& s) {
    const Extensions& e = c.profile.extensions;
    const PolygonOffsetState& offset = s.polygon_offset;
    c.extension(offset.enable || offset.lines || offset.points, e.polygon_offset, "polygon_offset");
    check_extensions(c, s.texture);
    c.extension(s.more_textures.units != nullptr, e.texture_units, "texture_units");
    if (s.more_textures.units)
        for (const TextureState& unit : *s.more_textures.units) check_extensions(c, unit);
    c.extension(s.line_stipple.enable || s.polygon_stipple.pattern, e.stipple, "stipple");
    c.extension(s.point_smooth || s.line_smooth || s.polygon_smooth, c.profile.coverage_bits > 0,
                "antialiasing");
    c.extension(s.point_parameters != PointParameters{}, e.point_parameters, "point_parameters");
    c.extension(s.point_sprite, e.point_sprite, "point_sprite");
    c.extension(s.two_side_polygon_mode, e.two_sided_polygon_mode, "two_sided_polygon_mode");
    if (s.stencil.test) {
        check_words(c, s.stencil);
        check_words(c, s.stencil.back);
    }
    c.extension(s.stencil.test && s.stencil.two_side, e.two_sided_stencil, "two_sided_stencil");
    c.extension(s.logic_op.enable, e.logic_op, "logic_op");
    c.extension(s.color_sum || s.lighting.separate_specular, e.secondary_color, "secondary_color");
    check_word(c, s.fog.source);
    check_word(c, s.clip_control.origin);
    check_word(c, s.clip_control.depth);
    const MultisampleState& m = s.multisample;
    c.extension(m.alpha_to_coverage || m.alpha_to_one || m.coverage_test, e.multisample,
                "multisample");
    check_words(c, s.blend);
}

template <class T>
inline constexpr bool is_numbers = std::is_floating_point_v<T> || std::is_same_v<T, vec4> ||
                                   std::is_same_v<T, dvec4> || std::is_same_v<T, dmat4>;
template <class T>
const auto* first_number(const T& v) {
    if constexpr (std::is_floating_point_v<T>)
        return &v;
    else if constexpr (std::is_same_v<T, dmat4>)
        return &v[0][0];
    else
        return &v.x;
}
template <class T>
bool is_finite(const T& v) {
    return all_finite(first_number(v), sizeof(T) / sizeof(*first_number(v)));
}

/// What the field's type and range allow. Names are made for messages only.
template <Plain T>
void check_value(const Checker& c, const Path& path, const T& v, const Bounds& bounds) {
    if (bounds.check == Bounds::Check::Rule) return;
    if constexpr (std::is_enum_v<T>) {
        if (v > last_of<T>) c.enumeration(path.without_elements().c_str(), v, last_of<T>);
    } else if constexpr (std::is_signed_v<T>) {
        if (bounds.check == Bounds::Check::Range && !(v >= bounds.least && v <= bounds.most))
            c.require(false, path.without_elements().c_str(), v,
                      fmt::format("{} to {}", bounds.least, bounds.most).c_str());
    }
    if constexpr (is_numbers<T>)
        if (!is_finite(v)) c.finite(path.without_elements().c_str(), v);
}

// ---- Rules of their own: Bounds::Check::Rule ----------------------------------------------------

void check_fog(const Checker& c, const FogState& fog) {
    if (!fog.enable) return;
    c.finite("fog.start", fog.start);
    c.finite("fog.end", fog.end);
    c.finite("fog.color", fog.color);
    if (fog.mode == FogMode::Linear)
        c.require(fog.end != fog.start, "fog.end", fog.end, "another value than fog.start");
    else
        c.require(fog.density > 0 && std::isfinite(fog.density), "fog.density", fog.density,
                  "a positive number");
}

void check_jitter(const Checker& c, const JitterState& jitter) {
    const int units = 1 << c.profile.subpixel_bits;
    c.require(jitter.x > -units && jitter.x < units, "jitter.x", jitter.x, "less than a pixel");
    c.require(jitter.y > -units && jitter.y < units, "jitter.y", jitter.y, "less than a pixel");
}

void check_factor(const Checker& c, const char* field, BlendFactor factor, bool is_allowed,
                  const char* side) {
    if (!is_allowed)
        c.fail(fmt::format("{} = {}; expected a {} factor", field, enumerator(factor), side));
}
/// SrcAlphaSaturate is a source factor even with blend_square.
void check_blend(const Checker& c, const BlendState& b) {
    const bool both = c.profile.extensions.blend_square;
    const auto source = [&](const char* field, BlendFactor f) {
        check_factor(c, field, f, both || is_source(f), "source");
    };
    const auto destination = [&](const char* field, BlendFactor f) {
        check_factor(c, field, f, is_destination(f) || (both && f != BlendFactor::SrcAlphaSaturate),
                     "destination");
    };
    source("blend.src", b.src);
    destination("blend.dst", b.dst);
    source("blend.alpha.src", b.alpha.src);
    destination("blend.alpha.dst", b.alpha.dst);
}

void check_scale(const Checker& c, const char* field, int scale) {
    c.require(scale == 1 || scale == 2 || scale == 4, field, scale, "1, 2 or 4");
}
void check_combine(const Checker& c, const TextureState& s) {
    check_scale(c, "texture.combine_rgb.scale", s.combine_rgb.scale);
    check_scale(c, "texture.combine_alpha.scale", s.combine_alpha.scale);
    c.enumeration("texture.combine_alpha.func", s.combine_alpha.func, CombineFunc::Subtract);
}

/// The sphere gives s and t only, normals and reflections give no q.
void check_coordinates(const Checker& c, const std::array<CoordinateGen, 4>& coordinates) {
    if (coordinates[2].mode == CoordinateMode::SphereMap)
        c.enumeration("texture.coordinates", coordinates[2].mode, CoordinateMode::EyeLinear);
    c.enumeration("texture.coordinates", coordinates[3].mode, CoordinateMode::EyeLinear);
}
void check_texture(const Checker& c, const TextureState& s) {
    check_coordinates(c, s.coordinates);
    check_combine(c, s);
}

void check_scissor(const Checker& c, const Rect& box) {
    c.require(box.width >= 0 && box.height >= 0, "scissor.box.width", box.width, "0 or more");
}

void check_buffers(const Checker& c, const State& s) {
    const bool two = c.profile.color_planes == 2;
    c.color_plane("draw_buffer", two || s.draw_buffer != DrawBuffer::Back, "Back");
    c.color_plane("draw_buffer", two || s.draw_buffer != DrawBuffer::FrontAndBack, "FrontAndBack");
    c.color_plane("read_buffer", two || s.read_buffer != ReadBuffer::Back, "Back");
}

void check_viewport(const Checker& c, const ViewportState& v) {
    const bool whole = v.width == 0 && v.height == 0;
    const char* const expected = c.sides("1 to 4096", "1 to 8192");
    c.require(whole || c.is_side(1, v.width), "viewport.width", v.width, expected);
    c.require(whole || c.is_side(1, v.height), "viewport.height", v.height, expected);
}

}  // namespace

void check(const Checker& c, const SetState& set) {
    const State& s = set.state;
    const auto [last, before] = c.checked_states;
    if (&s == last || &s == before) return;
    check_extensions(c, s);
    for_each_value(s, [&](const Path& path, const Plain auto& value, const auto& field) {
        check_value(c, path, value, field.bounds);
    });
    check_viewport(c, s.viewport);
    check_jitter(c, s.jitter);
    check_fog(c, s.fog);
    check_texture(c, s.texture);
    if (s.more_textures.units)
        for (const TextureState& unit : *s.more_textures.units) {
            const Path group{nullptr, "more_textures"};
            for_each_value(
                unit,
                [&](const Path& path, const Plain auto& value, const auto& field) {
                    check_value(c, path, value, field.bounds);
                },
                &group);
            check_texture(c, unit);
        }
    check_scissor(c, s.scissor.box);
    check_blend(c, s.blend);
    check_buffers(c, s);
    c.checked_states = {&s, last};
}

}  // namespace gw
