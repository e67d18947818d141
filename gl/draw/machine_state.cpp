#include "gl/draw/machine_state.h"

#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/targets.h"

#include "gw/describe/opengl.h"
#include "gw/stages/resolve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gw::gl {

namespace {

/// The machine's word. Calls have refused other numbers.
template <typename Enum>
Enum word(GLenum number) {
    return from_opengl<Enum>(number).value_or(Enum{});
}

Wrap wrap(GLenum mode, const Profile& p) {
    if (mode == GL_REPEAT || mode == GL_CLAMP_TO_BORDER || mode == GL_MIRRORED_REPEAT)
        return word<Wrap>(mode);
    return mode == GL_CLAMP && p.extensions.texture_border ? Wrap::BorderClamp : Wrap::Clamp;
}

/// Whether a float has more than 16 significant bits: it was probably rounded.
bool may_be_rounded(double element) {
    int exponent = 0;
    const double scaled = std::frexp(element, &exponent) * 0x1p16;
    return scaled != std::floor(scaled);
}

/// Depths nearer to the middle: what is drawn on the near or far plane stays inside, although the
/// matrix is rounded to floats. 2^-22 holds three roundings.
dmat4 with_room_for_rounding(dmat4 projection, bool zero_to_one) {
    bool is_rounded = false;
    for (int column = 0; column < 4; ++column) is_rounded |= may_be_rounded(projection[column][2]);
    const double room = is_rounded ? 0x1p-22 : 0x1p-40;
    for (int column = 0; column < 4; ++column) {
        projection[column][2] *= 1 - room;
        if (zero_to_one) projection[column][2] += room / 2 * projection[column][3];
    }
    return projection;
}

void set_transform(gw::State& out, const Context& context) {
    const State& s = context.state;
    if (context.profile.extensions.clip_control)
        out.clip_control = {word<ClipOrigin>(s.transform.clip_origin),
                            word<ClipDepth>(s.transform.clip_depth_mode)};
    const dmat4& projection = context.matrices.projection.top();
    out.projection =
        is_finite(projection)
            ? with_room_for_rounding(projection, out.clip_control.depth == ClipDepth::ZeroToOne)
            : gw::State{}.projection;
    // [GL12] 2.10.3: rescaling may make each normal's length 1.
    out.normalize = s.transform.normalize || s.transform.rescale_normal;
    out.viewport = {};
    if (!is_empty(s.viewport))
        out.viewport = {s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height};
    out.depth_range = {s.viewport.near_value, s.viewport.far_value};
    for (std::size_t i = 0; i < out.clip_planes.size(); ++i)
        out.clip_planes[i] = {s.transform.clip_enable[i], s.transform.clip_plane[i]};
}

void set_lighting(gw::State& out, const LightingState& s, const Extensions& has) {
    out.shade_model = word<gw::ShadeModel>(s.shade_model);
    out.color_source = s.enable ? ColorSource::Lighting : ColorSource::Vertex;
    out.lighting.local_viewer = s.local_viewer;
    out.lighting.two_side = s.two_side;
    out.lighting.model_ambient = s.model_ambient;
    out.lighting.separate_specular =
        has.secondary_color && s.color_control == GL_SEPARATE_SPECULAR_COLOR;
    out.lighting.color_material = {s.enable && s.color_material, word<Face>(s.color_material_face),
                                   word<gw::ColorMaterial>(s.color_material_mode)};
}

float clamped_size(float size) { return clamped(size, 1.0f, 128.0f); }

/// [R9.4], [R9.26]: whole pixels, or multiples of 2^-11 with antialiasing.
float machine_size(float size, bool smooth) {
    const float steps = smooth ? 2048.0f : 1.0f;
    return std::floor(clamped_size(size) * steps + 0.5f) / steps;
}

void set_sizes(gw::State& out, const State& s, const Profile& profile) {
    const bool smooths = profile.coverage_bits > 0;
    out.point_smooth = smooths && s.point.smooth;
    out.line_smooth = smooths && s.line.smooth;
    out.polygon_smooth = smooths && s.polygon.smooth;
    out.point_size = machine_size(s.point.size, out.point_smooth);
    const Extensions& has = profile.extensions;
    if (has.point_parameters)
        out.point_parameters = {.constant = s.point.attenuation.x,
                                .linear = s.point.attenuation.y,
                                .quadratic = s.point.attenuation.z,
                                .min_size = clamped_size(s.point.min_size),
                                .max_size = clamped_size(s.point.max_size)};
    out.point_sprite = has.point_sprite && s.point.sprite;
    out.line_width = machine_size(s.line.width, out.line_smooth);
    out.diamond_lines = true;
}

void set_rasterization(gw::State& out, const State& s, const Extensions& has) {
    const PolygonState& p = s.polygon;
    out.cull = {p.cull, word<Face>(p.cull_face), word<Winding>(p.front_face)};
    out.polygon_mode = word<gw::PolygonMode>(p.front_mode);
    out.back_polygon_mode = word<gw::PolygonMode>(p.back_mode);
    out.two_side_polygon_mode = p.front_mode != p.back_mode && has.two_sided_polygon_mode;
    if (has.stipple) {
        out.line_stipple = {s.line.stipple, s.line.stipple_factor, s.line.stipple_pattern};
        out.polygon_stipple.pattern = p.stipple ? s.polygon_stipple.pattern : nullptr;
    }
    out.polygon_offset = {};
    if (has.polygon_offset && (p.offset_fill || p.offset_line || p.offset_point))
        out.polygon_offset = {p.offset_fill, p.offset_factor, p.offset_units, p.offset_line,
                              p.offset_point};
}

CoordinateGen coordinate(const TexGenState& s) {
    if (!s.enable) return {};
    if (s.mode == GL_OBJECT_LINEAR) return {CoordinateMode::ObjectLinear, s.object_plane};
    if (s.mode == GL_EYE_LINEAR) return {CoordinateMode::EyeLinear, s.eye_plane};
    if (s.mode == GL_NORMAL_MAP) return {CoordinateMode::NormalMap, {}};
    if (s.mode == GL_REFLECTION_MAP) return {CoordinateMode::ReflectionMap, {}};
    return {CoordinateMode::SphereMap, {}};
}

void set_texture_coordinates(gw::TextureState& out, const Context& context, std::size_t unit) {
    const dmat4& matrix = context.matrices.texture[unit].top();
    const TextureUnit& s = context.state.texture.units[unit];
    if (is_finite(matrix)) out.matrix = matrix;
    for (std::size_t i = 0; i < 4; ++i) out.coordinates[i] = coordinate(s.gen[i]);
    if (s.generates()) out.gen = TexGen::PerCoordinate;
}

/// The matrix followed by that of rectangles.
dmat4 in_rectangle(dmat4 matrix, const dvec2& scale) {
    for (int column = 0; column < 4; ++column) {
        dvec4& c = matrix[column];
        for (int row = 0; row < 2; ++row) c[row] = rectangle_coordinate(c[row], c[3], scale[row]);
    }
    return matrix;
}

/// The machine's textures begin with the base level.
TextureLodState levels_of_detail(const TextureUnit& s, const TextureParameters& p) {
    return {.bias = clamped(s.lod_bias + p.lod_bias, -max_lod_bias, max_lod_bias),
            .min = p.min_lod,
            .max = p.max_lod};
}

gw::CombineState combine(const CombineState& s) {
    return {.func = word<CombineFunc>(s.func),
            .source0 = word<CombineSource>(s.source[0]),
            .source1 = word<CombineSource>(s.source[1]),
            .source2 = word<CombineSource>(s.source[2]),
            .operand0 = word<CombineOperand>(s.operand[0]),
            .operand1 = word<CombineOperand>(s.operand[1]),
            .operand2 = word<CombineOperand>(s.operand[2]),
            .scale = s.scale};
}

/// The look-up in the texture of a target.
void set_look_up(gw::TextureState& out, const Context& context, const TextureObject& object,
                 std::size_t target) {
    const Extensions& has = context.profile.extensions;
    const TextureParameters& p = object.parameters;
    out.min_filter = word<MinFilter>(p.min_filter);
    out.mag_filter = word<MagFilter>(p.mag_filter);
    out.wrap_s = wrap(p.wrap_s, context.profile);
    out.wrap_t = wrap(p.wrap_t, context.profile);
    if (target == three_dimensions) out.wrap_r = wrap(p.wrap_r, context.profile);
    out.border_color = p.border_color;
    out.exact_rho = true;
    out.seamless = target == cube && has.texture_seamless && context.state.texture.seamless;
    // [GL14] 3.8.14: colours are not compared.
    out.shadow_compare =
        p.compare_mode == GL_COMPARE_R_TO_TEXTURE && is_depths(object.base().internal_format);
    if (out.shadow_compare) out.compare_func = word<CompareFunc>(p.compare_func);
}

/// The texture of a unit, and its environment.
void set_texture(gw::TextureState& out, const Context& context, std::size_t unit) {
    const TextureUnit& s = context.state.texture.units[unit];
    const auto target = enabled_target(s);
    if (!target) return;
    const TextureObject& object = *context.textures.bound[unit][*target];
    const PointState& point = context.state.point;
    out.coord_replace =
        context.profile.extensions.point_sprite && point.sprite && point.coord_replace[unit];
    set_look_up(out, context, object, *target);
    if (*target == rectangular && context.selection.mode == GL_RENDER)
        out.matrix = in_rectangle(out.matrix, coordinate_scale(context, unit));
    out.env = word<gw::TexEnv>(s.env_mode);
    out.env_color = s.env_color;
    if (context.profile.extensions.texture_lod) out.lod = levels_of_detail(s, object.parameters);
    if (context.profile.extensions.texture_combine) {
        out.combine_rgb = combine(s.combine_rgb);
        out.combine_alpha = combine(s.combine_alpha);
    }
}

/// Feedback and the raster position have texture coordinates without a texture too.
void set_textures(gw::State& out, const Context& context) {
    out.texture = {};
    out.more_textures = {};
    set_texture_coordinates(out.texture, context, 0);
    set_texture(out.texture, context, 0);
    if (!context.state.texture.uses_further_units()) return;
    std::array<gw::TextureState, max_texture_units - 1> units;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit) {
        if (!context.state.texture.units[unit].is_enabled()) continue;
        set_texture_coordinates(units[unit - 1], context, unit);
        set_texture(units[unit - 1], context, unit);
    }
    out.more_textures.units = std::make_shared<const decltype(units)>(units);
}

void set_fog(gw::State& out, const FogState& s, const Extensions& has) {
    out.fog.enable = s.enable && (s.mode == GL_LINEAR || s.density > 0);  // of density 0: none
    out.fog.mode = word<FogMode>(s.mode);
    out.fog.density = s.density;
    out.fog.start = s.start;
    out.fog.end = s.end;
    if (s.start == s.end)  // the limit of ever shorter ranges
        out.fog.start = std::nextafter(s.end, -std::numeric_limits<float>::infinity());
    out.fog.color = s.color;
    out.fog.source = has.fog_coordinate && s.coordinate_source == GL_FOG_COORDINATE
                         ? FogSource::Coordinate
                         : FogSource::Depth;
    out.color_sum = has.secondary_color && s.color_sum;
}

gw::BlendAlphaState alpha_blend(const ColorBufferState& b) {
    if (b.blend_src_alpha == b.blend_src && b.blend_dst_alpha == b.blend_dst &&
        b.blend_equation_alpha == b.blend_equation)
        return {};
    return {true, word<BlendFactor>(b.blend_src_alpha), word<BlendFactor>(b.blend_dst_alpha),
            word<BlendEquation>(b.blend_equation_alpha)};
}

void set_fragments(gw::State& out, const State& s, const Extensions& has) {
    out.scissor = {s.scissor.test, s.scissor.box};
    const ColorBufferState& b = s.color_buffer;
    out.alpha = {b.alpha_test, word<CompareFunc>(b.alpha_func), b.alpha_ref};
    out.stencil.test = s.stencil.test;
    out.stencil.func = word<CompareFunc>(s.stencil.func);
    out.stencil.ref = s.stencil.ref;
    out.stencil.mask = s.stencil.mask;
    out.stencil.fail = word<gw::StencilOp>(s.stencil.fail);
    out.stencil.zfail = word<gw::StencilOp>(s.stencil.zfail);
    out.stencil.zpass = word<gw::StencilOp>(s.stencil.zpass);
    out.stencil.write_mask = s.stencil.write_mask;
    out.depth = {s.depth.test, word<CompareFunc>(s.depth.func), s.depth.mask};
    out.blend = {b.blend,
                 word<BlendFactor>(b.blend_src),
                 word<BlendFactor>(b.blend_dst),
                 word<BlendEquation>(b.blend_equation),
                 b.blend_color,
                 alpha_blend(b)};
    if (has.logic_op) out.logic_op = {b.logic_op, word<gw::LogicOp>(b.logic_op_mode)};
    out.color_mask = {b.mask[0], b.mask[1], b.mask[2], b.mask[3]};
    out.color_mask_bits = {b.mask_bits[0], b.mask_bits[1], b.mask_bits[2], b.mask_bits[3]};
}

/// [GL11] table 4.4, without right and auxiliary buffers.
DrawBuffer draw_buffer(GLenum mode) {
    switch (mode) {
        case GL_NONE: return DrawBuffer::None;
        case GL_BACK:
        case GL_BACK_LEFT: return DrawBuffer::Back;
        case GL_LEFT:
        case GL_FRONT_AND_BACK: return DrawBuffer::FrontAndBack;
    }
    return DrawBuffer::Front;
}

/// Drawing leaves alone what a framebuffer object lacks. [R16.3] does so for planes that its surface
/// lacks; it may have more, or be larger.
void set_attachments(gw::State& out, const Context& context) {
    const Framebuffer& f = *context.framebuffers.draw;
    const auto color = attached_image(f.at(Plane::Color));
    if (!color || context.state.color_buffer.draw_buffer == GL_NONE)
        out.color_mask = {false, false, false, false};
    else if (base_format(color->internal_format) == GL_RGB)
        out.color_mask.a = false;
    if (!f.at(Plane::Depth).is_given()) out.depth.test = out.depth.mask = false;
    if (!f.at(Plane::Stencil).is_given()) {
        out.stencil.test = false;
        out.stencil.write_mask = 0;
    }
    const FramebufferSize size = size_of(f);
    if (has_one_size(f)) return;
    const Rect all{0, 0, size.width, size.height};
    out.scissor = {true, out.scissor.test ? intersect(out.scissor.box, all) : all};
}

void set_buffers(gw::State& out, const Context& context) {
    const MultisampleState& m = context.state.multisample;
    out.multisample = {};
    if (draw_samples(context) > 0)
        out.multisample = {m.multisample, m.alpha_to_coverage, m.alpha_to_one,
                           m.coverage,    m.coverage_value,    m.coverage_invert};
    out.draw_buffer = DrawBuffer::Front;
    out.read_buffer = gw::ReadBuffer::Front;
    if (context.framebuffers.draw) return set_attachments(out, context);
    const GLenum draw = context.state.color_buffer.draw_buffer,
                 read = context.state.pixel.read_buffer;
    if (context.drawable != nullptr && context.drawable->has_back_plane()) {
        out.draw_buffer = draw_buffer(draw);
        out.read_buffer =
            read == GL_BACK || read == GL_BACK_LEFT ? gw::ReadBuffer::Back : gw::ReadBuffer::Front;
    } else if (draw == GL_NONE) {
        out.color_mask = {false, false, false, false};
    }
}

}  // namespace

void translate_state(const Context& context, StateParts parts, gw::State& out) {
    const State& from = context.state;
    const Extensions& has = context.profile.extensions;
    if ((parts & transform_part) != 0) set_transform(out, context);
    if ((parts & lighting_part) != 0) set_lighting(out, from.lighting, has);
    if ((parts & shape_part) != 0) {
        set_sizes(out, from, context.profile);
        set_rasterization(out, from, has);
    }
    if ((parts & texture_part) != 0) set_textures(out, context);
    if ((parts & fog_part) != 0) set_fog(out, from.fog, has);
    if ((parts & fragment_part) != 0) {
        set_fragments(out, from, has);
        set_buffers(out, context);
    }
}

double window_depth(double z, const gw::State& state) {
    const double n = state.depth_range.near_value, f = state.depth_range.far_value;
    if (state.clip_control.depth == ClipDepth::ZeroToOne) return z * (f - n) + n;
    return z * ((f - n) / 2) + (f + n) / 2;
}

dvec2 coordinate_scale(const Context& context, std::size_t unit) {
    if (enabled_target(context.state.texture.units[unit]) != rectangular) return {1, 1};
    const TextureImage& image = context.textures.bound[unit][rectangular]->base();
    return {1.0 / std::max(1, image.width), 1.0 / std::max(1, image.height)};
}

gw::MoreTextures further_coordinates(const Context& context) {
    std::array<gw::TextureState, max_texture_units - 1> units;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        set_texture_coordinates(units[unit - 1], context, unit);
    return {std::make_shared<const decltype(units)>(units)};
}

}  // namespace gw::gl
