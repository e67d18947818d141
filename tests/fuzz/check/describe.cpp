#include "tests/fuzz/check/describe.h"

#include <fmt/format.h>

namespace gw::fuzz {
namespace {

std::string text(const Rect& r) { return fmt::format("{} {} {}x{}", r.x, r.y, r.width, r.height); }
std::string text(const vec4& v) { return fmt::format("({} {} {} {})", v.x, v.y, v.z, v.w); }
std::string text(const dmat4& m) {
    std::string out;
    for (int row = 0; row < 4; ++row)
        out += fmt::format("[{:g} {:g} {:g} {:g}]", m[0][row], m[1][row], m[2][row], m[3][row]);
    return out;
}

template <typename Face>
std::string stencil_text(const Face& f) {
    return fmt::format("func {} ref {} mask {:x} fail {} zfail {} zpass {} write {:x}", int(f.func),
                       f.ref, f.mask, int(f.fail), int(f.zfail), int(f.zpass), f.write_mask);
}

std::string texture_text(const TextureState& t) {
    return fmt::format("min {} mag {} wrap {} {} env {} {} gen {} eta {} compare {} eye_linear {}",
                       int(t.min_filter), int(t.mag_filter), int(t.wrap_s), int(t.wrap_t),
                       int(t.env), text(t.env_color), int(t.gen), t.eta, t.shadow_compare,
                       text(t.eye_linear));
}

/// The fields of the geometry stages that differ from State{}.
std::string geometry_text(const State& s, const State& initial) {
    std::string out = fmt::format(" projection {}", text(s.projection));
    const auto add = [&](bool differs, const std::string& words) {
        out += differs ? "; " + words : "";
    };
    add(s.viewport != initial.viewport,
        "viewport " + text(Rect{s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height}));
    add(s.depth_range != initial.depth_range,
        fmt::format("range {} {}", s.depth_range.near_value, s.depth_range.far_value));
    for (const ClipPlane& p : s.clip_planes)
        add(p.enable,
            fmt::format("plane {:g} {:g} {:g} {:g}", p.plane.x, p.plane.y, p.plane.z, p.plane.w));
    add(s.cull != initial.cull, fmt::format("cull {} face {} front {}", s.cull.enable,
                                            int(s.cull.face), int(s.cull.front)));
    add(s.polygon_mode != initial.polygon_mode, fmt::format("mode {}", int(s.polygon_mode)));
    add(s.polygon_offset != initial.polygon_offset,
        fmt::format("offset {} {} {}", s.polygon_offset.enable, s.polygon_offset.factor,
                    s.polygon_offset.units));
    add(s.jitter != initial.jitter, fmt::format("jitter {} {}", s.jitter.x, s.jitter.y));
    add(s.point_size != 1 || s.line_width != 1,
        fmt::format("point {} line {}", s.point_size, s.line_width));
    add(antialiases(s),
        fmt::format("smooth {} {} {}", s.point_smooth, s.line_smooth, s.polygon_smooth));
    return out;
}

std::string fragment_text(const State& s, const State& initial) {
    std::string out;
    const auto add = [&](bool differs, const std::string& words) {
        out += differs ? "; " + words : "";
    };
    add(s.shade_model != initial.shade_model, "flat");
    add(s.color_source != initial.color_source, fmt::format("source {}", int(s.color_source)));
    add(s.lighting != initial.lighting,
        fmt::format("local {} two_side {}", s.lighting.local_viewer, s.lighting.two_side));
    add(s.fog != initial.fog, fmt::format("fog {} mode {} density {} {}..{} color {} coordinate {}",
                                          s.fog.enable, int(s.fog.mode), s.fog.density, s.fog.start,
                                          s.fog.end, text(s.fog.color), int(s.fog.coordinate)));
    add(s.texture != initial.texture, "texture " + texture_text(s.texture));
    add(s.scissor != initial.scissor,
        fmt::format("scissor {} {}", s.scissor.test, text(s.scissor.box)));
    add(s.alpha != initial.alpha,
        fmt::format("alpha {} {} {}", s.alpha.test, int(s.alpha.func), s.alpha.ref));
    add(s.stencil != initial.stencil,
        fmt::format("stencil {} {}", s.stencil.test, stencil_text(s.stencil)));
    add(s.stencil.two_side, "back " + stencil_text(s.stencil.back));
    add(s.depth != initial.depth,
        fmt::format("depth {} func {} mask {}", s.depth.test, int(s.depth.func), s.depth.mask));
    add(s.blend != initial.blend,
        fmt::format("blend {} {} {}", s.blend.enable, int(s.blend.src), int(s.blend.dst)));
    add(s.blend.alpha.separate, fmt::format("alpha {} {} {}", int(s.blend.alpha.src),
                                            int(s.blend.alpha.dst), int(s.blend.alpha.equation)));
    add(s.color_mask != initial.color_mask,
        fmt::format("mask {:d}{:d}{:d}{:d}", s.color_mask.r, s.color_mask.g, s.color_mask.b,
                    s.color_mask.a));
    add(s.draw_buffer != initial.draw_buffer || s.read_buffer != initial.read_buffer,
        fmt::format("draw buffer {} read buffer {}", int(s.draw_buffer), int(s.read_buffer)));
    return out;
}

std::string mesh_text(const Mesh& mesh) {
    const MeshData& m = mesh.data();
    std::string out = fmt::format("primitive {}, {} vertices, {} indices", int(m.primitive),
                                  m.positions.size(), m.indices.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(m.positions.size(), 12); ++i)
        out += fmt::format(" ({:.9g} {:.9g} {:.9g})", m.positions[i].x, m.positions[i].y,
                           m.positions[i].z);
    return out;
}

std::string text(const BeginPass& c) {
    return fmt::format("BeginPass '{}' digests {}", c.name, c.digests);
}
std::string text(const Clear& c) {
    return fmt::format("Clear planes {} color {} depth {} stencil {} accum {}", c.planes,
                       text(c.color), c.depth, c.stencil, text(c.accum));
}
std::string text(const SetState& c) {
    return "SetState" + geometry_text(c.state, {}) + fragment_text(c.state, {});
}
std::string text(const Draw& c) {
    return fmt::format(
        "Draw {} eye_from_object {} lights {} map {} id {} >> {}", mesh_text(*c.mesh),
        text(c.eye_from_object), c.lights ? int(c.lights->size()) : -1,
        c.map.slot      ? fmt::format("slot {}", *c.map.slot)
        : c.map.surface ? fmt::format("plane {} of surface {}", int(c.map.surface->plane),
                                      c.map.surface->surface)
        : c.map.texture ? fmt::format("{}x{}", c.map.texture->width(), c.map.texture->height())
                        : "none",
        c.id_base, c.id_shift);
}
std::string text(const WriteSpans& c) {
    return fmt::format("WriteSpans {} depth {}", c.spans.size(), c.depth);
}
std::string text(const WritePixels& c) {
    return fmt::format("WritePixels plane {} {} depth {}", int(c.plane), text(c.rect), c.depth);
}
std::string text(const Accumulate& c) {
    return fmt::format("Accumulate {} {}", int(c.op), c.value);
}
std::string text(const Copy& c) {
    return fmt::format("Copy plane {} {} to {} {}", int(c.plane), text(c.source), c.x, c.y);
}
std::string text(const CopyTexture& c) {
    return fmt::format("CopyTexture slot {} plane {} {}", c.slot, int(c.plane), text(c.rect));
}
std::string text(const DrawPixels& c) {
    const RasterPosition& r = c.raster;
    return fmt::format(
        "DrawPixels {}x{} at {} {} zoom {} {} colors {} depths {} stencils {} bits {} source {} map {}",
        c.width, c.height, r.x, r.y, c.zoom_x, c.zoom_y, c.colors.size(), c.depths.size(),
        c.stencils.size(), c.bits.size(), c.source ? int(c.source->plane) : -1, c.map.enabled());
}
std::string text(const Read& c) {
    return fmt::format("Read {} plane {} {}{}", c.key, int(c.plane), text(c.rect),
                       c.packed ? " packed" : "");
}

std::string text(const Query& c) { return fmt::format("Query {} begin {}", c.key, c.begin); }
std::string text(const MakeSurface& c) {
    return fmt::format("MakeSurface {} {}x{} planes {} depth_bits {} samples {}", c.number,
                       c.surface.width, c.surface.height, c.surface.planes, c.surface.depth_bits,
                       c.surface.samples);
}
std::string text(const UseSurface& c) { return fmt::format("UseSurface {}", c.number); }
std::string text(const Blit& c) {
    return fmt::format("Blit from {} planes {} {} to {} flips {} {} filter {}", c.from_surface,
                       c.planes, text(c.source), text(c.target), c.flip_x, c.flip_y, int(c.filter));
}
std::string text(const SwapBuffers&) { return "SwapBuffers"; }

}  // namespace

std::string describe(const Command& command) {
    return std::visit([](const auto& c) { return text(c); }, command);
}

std::string describe(const Case& c) {
    const Profile& p = c.profile;
    std::string out = fmt::format(
        "window {}x{}, profile {}: color {} depth {} stencil {} accum {} subpixel {} lit {} fragment_fog {} "
        "perspective_color {}\n",
        c.width, c.height, p.name, p.color_bits, p.depth_bits, p.stencil_bits, p.accum_bits,
        p.subpixel_bits, p.lit_bits, p.fragment_fog, p.perspective_color);
    for (std::size_t i = 0; i < c.list.commands.size(); ++i)
        out += fmt::format("  {}: {}\n", i, describe(c.list.commands[i]));
    return out;
}

}  // namespace gw::fuzz
