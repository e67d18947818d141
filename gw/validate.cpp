// Checking a command list before anything is drawn: extensions by name, values in range, sizes that
// fit.
// Does not look at meshes or textures: make_mesh and make_texture have checked those.
#include "gw/machine.h"

#include "gw/base/arithmetic.h"
#include "gw/command_name.h"
#include "gw/error.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace gw {
namespace {

/// Where in the list we are, for messages.
struct Checker {
    const Profile& profile;
    int width = 0, height = 0;
    std::size_t command = 0;
    const char* name = "";

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("command {} ({}): {}", command, name, what));
    }
    void require(bool ok, const char* what, const auto& value, const char* expected) const {
        if (!ok) fail(fmt::format("{} = {}; expected {}", what, value, expected));
    }
    void extension(bool used, bool present, const char* extension) const {
        if (used && !present)
            fail(fmt::format("extension {} is not in profile {}", extension, profile.name));
    }
    void position(const char* what, int v) const {
        require(v >= -max_window_size && v <= max_window_size, what, v, "-4096 to 4096");
    }
    void finite(const char* what, double v) const {
        require(std::isfinite(v), what, v, "a finite number");
    }
    void finite(const char* what, const vec4& v) const {
        for (int i = 0; i < 4; ++i) finite(what, double(v[i]));
    }
    void finite(const char* what, const vec3& v) const {
        for (int i = 0; i < 3; ++i) finite(what, double(v[i]));
    }
    void finite(const char* what, const dmat4& m) const {
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) finite(what, m[c][r]);
    }
};

bool wraps(const StencilOp op) { return op == StencilOp::IncrWrap || op == StencilOp::DecrWrap; }
bool wraps(const auto& s) { return wraps(s.fail) || wraps(s.zfail) || wraps(s.zpass); }

void check_extensions(const Checker& c, const State& s) {
    const Extensions& e = c.profile.extensions;
    c.extension(s.polygon_offset.enable, e.polygon_offset, "polygon_offset");
    c.extension(s.texture.shadow_compare, e.shadow_texture, "shadow_texture");
    c.extension(s.stencil.test && (wraps(s.stencil) || wraps(s.stencil.back)), e.stencil_wrap,
                "stencil_wrap");
    c.extension(s.stencil.test && s.stencil.two_side, e.two_sided_stencil, "two_sided_stencil");
}

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

void check_rasterization(const Checker& c, const State& s) {
    const int units = 1 << c.profile.subpixel_bits;
    c.require(s.jitter.x > -units && s.jitter.x < units, "jitter.x", s.jitter.x,
              "less than a pixel");
    c.require(s.jitter.y > -units && s.jitter.y < units, "jitter.y", s.jitter.y,
              "less than a pixel");
    c.require(s.point_size >= 1 && s.point_size <= 128, "point_size", s.point_size, "1 to 128");
    c.require(s.line_width >= 1 && s.line_width <= 128, "line_width", s.line_width, "1 to 128");
    c.finite("polygon_offset.factor", s.polygon_offset.factor);
    c.finite("polygon_offset.units", s.polygon_offset.units);
}

/// [GL11] tables 4.1 and 4.2: a colour is a factor for the other side only.
void check_blend(const Checker& c, const BlendState& b) {
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

void check(const Checker& c, const SetState& command) {
    const State& s = command.state;
    check_extensions(c, s);
    c.finite("projection", s.projection);
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
    for (const ClipPlane& plane : s.clip_planes)
        for (int i = 0; i < 4; ++i) c.finite("clip_planes", plane.plane[i]);
    check_rasterization(c, s);
    check_blend(c, s.blend);
    check_fog(c, s.fog);
    c.require(s.scissor.box.width >= 0 && s.scissor.box.height >= 0, "scissor.box.width",
              s.scissor.box.width, "0 or more");
    c.require(std::isfinite(s.alpha.ref), "alpha.ref", s.alpha.ref, "a finite number");
    c.finite("lighting.model_ambient", s.lighting.model_ambient);
    c.finite("texture.eta", s.texture.eta);
    c.finite("texture.eye_linear", s.texture.eye_linear);
    c.finite("texture.env_color", s.texture.env_color);
}

void check_light(const Checker& c, const Light& light) {
    c.finite("light.position", light.position);
    c.finite("light.Ia", light.Ia);
    c.finite("light.Id", light.Id);
    c.finite("light.Is", light.Is);
    c.finite("light.spot_direction", light.spot_direction);
    c.require(light.spot_exponent >= 0 && light.spot_exponent <= 128, "light.spot_exponent",
              light.spot_exponent, "0 to 128");
    c.require(light.spot_cos_cutoff >= -1 && light.spot_cos_cutoff <= 1, "light.spot_cos_cutoff",
              light.spot_cos_cutoff, "-1 to 1");
    for (const float a :
         {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation})
        c.require(a >= 0 && std::isfinite(a), "light attenuation", a, "0 or more");
}

void check(const Checker& c, const Draw& draw) {
    c.require(draw.mesh != nullptr, "mesh", "null", "a mesh");
    c.finite("eye_from_object", draw.eye_from_object);
    const dmat4& m = draw.eye_from_object;
    c.require(m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1,
              "eye_from_object's last row", "not 0 0 0 1", "an affine matrix");
    for (const vec3& v : {draw.material.Ka, draw.material.Kd, draw.material.Ks, draw.material.Ke})
        c.finite("material", v);
    c.require(draw.material.Ns >= 0 && draw.material.Ns <= 10000, "material.Ns", draw.material.Ns,
              "0 to 10000");
    c.require(std::isfinite(draw.material.alpha), "material.alpha", draw.material.alpha,
              "a finite number");
    c.require(draw.id_shift >= 0 && draw.id_shift < 32, "id_shift", draw.id_shift, "0 to 31");
    if (!draw.lights) return;
    c.require(int(draw.lights->size()) <= c.profile.max_lights, "lights in one pass",
              draw.lights->size(),
              fmt::format("at most {} (profile {})", c.profile.max_lights, c.profile.name).c_str());
    for (const Light& light : *draw.lights) check_light(c, light);
}

void check_colors(const Checker& c, const std::vector<Rgba>& colors) {
    const std::uint32_t max = max_of_bits(c.profile.color_bits);
    for (const Rgba& color : colors)
        for (const std::uint16_t v : color)
            if (v > max)
                c.fail(fmt::format("colour value {}; expected at most {} (profile {})", v, max,
                                   c.profile.name));
}

void check(const Checker& c, const WriteSpans& w) {
    check_colors(c, w.colors);
    c.require(w.depth <= max_of_bits(c.profile.depth_bits), "depth", w.depth,
              "a value of the depth plane");
    for (const Span& s : w.spans) {
        c.position("span x", s.x);
        c.position("span y", s.y);
        c.require(s.length >= 0, "span length", s.length, "0 or more");
        const std::uint64_t last =
            std::uint64_t{s.first} + (s.flat || s.length == 0 ? 1 : std::uint64_t(s.length));
        c.require(last <= w.colors.size(), "span's last colour", last,
                  "at most the number of colours");
    }
}

std::size_t area(const Rect& r) { return std::size_t(r.width) * std::size_t(r.height); }

void check_size(const Checker& c, const Rect& r) {
    c.require(r.width >= 0 && r.width <= max_window_size, "rect.width", r.width, "0 to 4096");
    c.require(r.height >= 0 && r.height <= max_window_size, "rect.height", r.height, "0 to 4096");
}

void check(const Checker& c, const WritePixels& w) {
    check_size(c, w.rect);
    c.position("rect.x", w.rect.x);
    c.position("rect.y", w.rect.y);
    check_colors(c, w.colors);
    c.require(w.plane != Plane::Accum, "plane", "Accum", "Color, Depth or Stencil");
    const std::size_t given = w.plane == Plane::Color ? w.colors.size() : w.values.size();
    c.require(given == area(w.rect), "pixels given", given, "width times height");
    const std::uint32_t max =
        max_of_bits(w.plane == Plane::Stencil ? c.profile.stencil_bits : c.profile.depth_bits);
    c.require(w.depth <= max_of_bits(c.profile.depth_bits), "depth", w.depth,
              "a value of the depth plane");
    for (const std::uint32_t v : w.values)
        if (v > max)
            c.fail(fmt::format("pixel value {}; expected at most {} (profile {})", v, max,
                               c.profile.name));
}

void check_inside(const Checker& c, const Rect& r) {
    check_size(c, r);
    if (r.x < 0 || r.y < 0 || r.x > c.width - r.width || r.y > c.height - r.height)
        c.fail(fmt::format("rect = {} {} {} {}; expected one inside the window", r.x, r.y, r.width,
                           r.height));
}

void check(const Checker& c, const Copy& copy) {
    check_size(c, copy.source);
    c.require(copy.plane != Plane::Accum, "plane", "Accum", "Color, Depth or Stencil");
    for (const int v : {copy.source.x, copy.source.y, copy.x, copy.y})
        c.position("copy position", v);
}

void check(const Checker& c, const CopyTexture& copy) {
    check_inside(c, copy.rect);
    c.require(copy.slot < 256, "slot", copy.slot, "0 to 255");
    c.require(copy.plane == Plane::Color || copy.plane == Plane::Depth, "plane", int(copy.plane),
              "Color or Depth");
    c.require(std::has_single_bit(unsigned(copy.rect.width)), "rect.width", copy.rect.width,
              "a power of two");
    c.require(std::has_single_bit(unsigned(copy.rect.height)), "rect.height", copy.rect.height,
              "a power of two");
}

void check(const Checker& c, const Read& read) {
    check_inside(c, read.rect);
    if (!read.packed) return;
    c.require(read.plane == Plane::Color, "plane of packed pixels", int(read.plane), "Color");
    c.require(c.profile.color_bits <= 8, "color_bits of packed pixels", c.profile.color_bits,
              "at most 8");
}
void check(const Checker& c, const Accumulate& a) { c.finite("value", a.value); }
void check(const Checker&, const BeginPass&) {}
void check(const Checker& c, const Clear& clear) {
    c.finite("color", clear.color);
    c.finite("depth", clear.depth);
}

/// What only the order of commands can get wrong: textures from slots that hold the wrong plane, or
/// nothing.
void check_slot(const Checker& c, const Draw& draw, const ListContext& context) {
    if (!draw.map.enabled()) return;
    const bool compares = context.state.texture.shadow_compare;
    if (!draw.map.slot) {
        if (compares)
            c.fail(
                "texture.shadow_compare with a colour texture; expected a slot copied from the depth plane");
        return;
    }
    const auto slot = context.slots.find(*draw.map.slot);
    if (slot == context.slots.end())
        c.fail(
            fmt::format("texture slot {} is empty; expected a CopyTexture before", *draw.map.slot));
    if (compares && slot->second != Plane::Depth)
        c.fail(fmt::format(
            "texture.shadow_compare with slot {} of the colour plane; expected the depth plane",
            *draw.map.slot));
}

void follow(const Checker&, const auto&, ListContext&) {}
void follow(const Checker& c, const Draw& draw, ListContext& context) {
    check_slot(c, draw, context);
}
void follow(const Checker&, const SetState& set, ListContext& context) {
    context.state = set.state;
}
void follow(const Checker&, const CopyTexture& copy, ListContext& context) {
    context.slots[copy.slot] = copy.plane;
}

}  // namespace

void check_window(int width, int height) {
    if (width < 1 || height < 1 || width > max_window_size || height > max_window_size)
        throw Error(fmt::format("window of {} x {} pixels; expected 1 to {} each", width, height,
                                max_window_size));
}

void validate(const CommandList& list, const Profile& profile, int width, int height,
              ListContext context) {
    Checker checker{profile, width, height};
    for (const Command& command : list.commands) {
        checker.name = command_name(command);
        std::visit([&](const auto& c) { check(checker, c); }, command);
        std::visit([&](const auto& c) { follow(checker, c, context); }, command);
        checker.command += 1;
    }
}

}  // namespace gw
