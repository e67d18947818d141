// Checks SetState: extensions, enumerations, ranges and finite numbers of the whole state.
#include "gw/validate/checker.h"

namespace gw {
namespace {

bool wraps(const StencilOp op) { return op == StencilOp::IncrWrap || op == StencilOp::DecrWrap; }
bool wraps(const auto& s) { return wraps(s.fail) || wraps(s.zfail) || wraps(s.zpass); }

bool is_constant(BlendFactor f) { return f >= BlendFactor::ConstantColor; }

void check_blend_extensions(const Checker& c, const BlendState& b) {
    const Extensions& e = c.profile.extensions;
    using enum BlendEquation;
    c.extension(b.enable && (is_constant(b.src) || is_constant(b.dst)), e.blend_color,
                "blend_color");
    c.extension(b.enable && (b.equation == Min || b.equation == Max), e.blend_minmax,
                "blend_minmax");
    c.extension(b.enable && (b.equation == Subtract || b.equation == ReverseSubtract),
                e.blend_subtract, "blend_subtract");
}

void check_extensions(const Checker& c, const State& s) {
    const Extensions& e = c.profile.extensions;
    const PolygonOffsetState& offset = s.polygon_offset;
    c.extension(offset.enable || offset.lines || offset.points, e.polygon_offset, "polygon_offset");
    c.extension(s.texture.wrap_s == Wrap::BorderClamp || s.texture.wrap_t == Wrap::BorderClamp,
                e.texture_border, "texture_border");
    c.extension(s.line_stipple.enable || s.polygon_stipple.pattern, e.stipple, "stipple");
    c.extension(s.point_smooth || s.line_smooth || s.polygon_smooth, c.profile.coverage_bits > 0,
                "antialiasing");
    c.extension(s.two_side_polygon_mode, e.two_sided_polygon_mode, "two_sided_polygon_mode");
    c.extension(s.texture.shadow_compare, e.shadow_texture, "shadow_texture");
    c.extension(s.stencil.test && (wraps(s.stencil) || wraps(s.stencil.back)), e.stencil_wrap,
                "stencil_wrap");
    c.extension(s.stencil.test && s.stencil.two_side, e.two_sided_stencil, "two_sided_stencil");
    c.extension(s.logic_op.enable, e.logic_op, "logic_op");
    check_blend_extensions(c, s.blend);
}

void check_fog(const Checker& c, const FogState& fog) {
    c.enumeration("fog.mode", fog.mode, FogMode::Exp2);
    c.enumeration("fog.coordinate", fog.coordinate, FogCoordinate::Fragment);
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

void check_rasterization(const Checker& c, const State& s) {
    const int units = 1 << c.profile.subpixel_bits;
    c.enumeration("cull.face", s.cull.face, Face::FrontAndBack);
    c.enumeration("cull.front", s.cull.front, Winding::CCW);
    c.enumeration("polygon_mode", s.polygon_mode, PolygonMode::Fill);
    c.enumeration("back_polygon_mode", s.back_polygon_mode, PolygonMode::Fill);
    c.require(s.line_stipple.factor >= 1 && s.line_stipple.factor <= 256, "line_stipple.factor",
              s.line_stipple.factor, "1 to 256");
    c.enumeration("shade_model", s.shade_model, ShadeModel::Smooth);
    c.enumeration("color_source", s.color_source, ColorSource::PolygonId);
    c.require(s.jitter.x > -units && s.jitter.x < units, "jitter.x", s.jitter.x,
              "less than a pixel");
    c.require(s.jitter.y > -units && s.jitter.y < units, "jitter.y", s.jitter.y,
              "less than a pixel");
    c.require(s.point_size >= 1 && s.point_size <= 128, "point_size", s.point_size, "1 to 128");
    c.require(s.line_width >= 1 && s.line_width <= 128, "line_width", s.line_width, "1 to 128");
    c.finite("polygon_offset.factor", s.polygon_offset.factor);
    c.finite("polygon_offset.units", s.polygon_offset.units);
}

/// [GL11] tables 4.1 and 4.2: each colour factor is allowed on one side only.
void check_blend(const Checker& c, const BlendState& b) {
    c.enumeration("blend.src", b.src, BlendFactor::OneMinusConstantAlpha);
    c.enumeration("blend.dst", b.dst, BlendFactor::OneMinusConstantAlpha);
    c.enumeration("blend.equation", b.equation, BlendEquation::Max);
    c.finite("blend.color", b.color);
    const auto refuse = [&](const char* field, BlendFactor given, BlendFactor factor,
                            const char* word) {
        if (given == factor)
            c.fail(fmt::format("blend.{} = {}; expected a {} factor", field, word,
                               field[0] == 's' ? "source" : "destination"));
    };
    refuse("src", b.src, BlendFactor::SrcColor, "SrcColor");
    refuse("src", b.src, BlendFactor::OneMinusSrcColor, "OneMinusSrcColor");
    refuse("dst", b.dst, BlendFactor::DstColor, "DstColor");
    refuse("dst", b.dst, BlendFactor::OneMinusDstColor, "OneMinusDstColor");
    refuse("dst", b.dst, BlendFactor::SrcAlphaSaturate, "SrcAlphaSaturate");
}

void check_stencil(const Checker& c, const StencilFace& face) {
    c.enumeration("stencil.func", face.func, StencilFunc::Always);
    for (const StencilOp op : {face.fail, face.zfail, face.zpass})
        c.enumeration("stencil operation", op, StencilOp::DecrWrap);
}

void check_texture(const Checker& c, const TextureState& t) {
    c.enumeration("texture.min_filter", t.min_filter, MinFilter::LinearMipmapLinear);
    c.enumeration("texture.mag_filter", t.mag_filter, MagFilter::Linear);
    c.enumeration("texture.wrap_s", t.wrap_s, Wrap::BorderClamp);
    c.enumeration("texture.wrap_t", t.wrap_t, Wrap::BorderClamp);
    c.enumeration("texture.env", t.env, TexEnv::Replace);
    c.enumeration("texture.gen", t.gen, TexGen::PerCoordinate);
    for (std::size_t i = 0; i < 4; ++i) {
        const CoordinateMode last = i < 2 ? CoordinateMode::SphereMap : CoordinateMode::EyeLinear;
        c.enumeration("texture.coordinates", t.coordinates[i].mode, last);
        c.finite("texture.coordinates", t.coordinates[i].plane);
    }
    c.finite("texture.matrix", t.matrix);
    c.finite("texture.border_color", t.border_color);
    c.finite("texture.eta", t.eta);
    c.finite("texture.eye_linear", t.eye_linear);
    c.finite("texture.env_color", t.env_color);
}

void check_fragment_tests(const Checker& c, const State& s) {
    c.require(s.scissor.box.width >= 0 && s.scissor.box.height >= 0, "scissor.box.width",
              s.scissor.box.width, "0 or more");
    c.enumeration("alpha.func", s.alpha.func, AlphaFunc::Always);
    c.require(std::isfinite(s.alpha.ref), "alpha.ref", s.alpha.ref, "a finite number");
    check_stencil(c, s.stencil.front());
    check_stencil(c, s.stencil.back);
    c.enumeration("depth.func", s.depth.func, DepthFunc::Always);
}

void check_buffers(const Checker& c, const State& s) {
    c.enumeration("draw_buffer", s.draw_buffer, DrawBuffer::FrontAndBack);
    c.enumeration("read_buffer", s.read_buffer, ReadBuffer::Back);
    const bool two = c.profile.color_planes == 2;
    c.color_plane("draw_buffer", two || s.draw_buffer != DrawBuffer::Back, "Back");
    c.color_plane("draw_buffer", two || s.draw_buffer != DrawBuffer::FrontAndBack, "FrontAndBack");
    c.color_plane("read_buffer", two || s.read_buffer != ReadBuffer::Back, "Back");
}

void check_viewport(const Checker& c, const State& s) {
    const ViewportState& v = s.viewport;
    const bool whole = v.width == 0 && v.height == 0;
    c.require(whole || (v.width >= 1 && v.width <= max_window_size), "viewport.width", v.width,
              "1 to 4096");
    c.require(whole || (v.height >= 1 && v.height <= max_window_size), "viewport.height", v.height,
              "1 to 4096");
    c.position("viewport.x", v.x);
    c.position("viewport.y", v.y);
    c.finite("depth_range.near_value", s.depth_range.near_value);
    c.finite("depth_range.far_value", s.depth_range.far_value);
}

}  // namespace

void check(const Checker& c, const SetState& set) {
    const State& s = set.state;
    check_extensions(c, s);
    c.finite("projection", s.projection);
    check_viewport(c, s);
    for (const ClipPlane& plane : s.clip_planes)
        for (int i = 0; i < 4; ++i) c.finite("clip_planes", plane.plane[i]);
    check_rasterization(c, s);
    check_blend(c, s.blend);
    c.enumeration("logic_op.op", s.logic_op.op, LogicOp::Set);
    check_fog(c, s.fog);
    check_fragment_tests(c, s);
    check_buffers(c, s);
    c.finite("lighting.model_ambient", s.lighting.model_ambient);
    c.enumeration("lighting.color_material.face", s.lighting.color_material.face,
                  Face::FrontAndBack);
    c.enumeration("lighting.color_material.mode", s.lighting.color_material.mode,
                  ColorMaterial::AmbientAndDiffuse);
    check_texture(c, s.texture);
}

}  // namespace gw
