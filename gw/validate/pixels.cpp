// Checks commands on pixels: their rectangles, spans, values and planes. BeginPass: its digests.
#include "gw/validate/checker.h"

#include <bit>

namespace gw {
namespace {

void check_colors(const Checker& c, const std::vector<Rgba>& colors) {
    const std::uint32_t max = max_of_bits(c.profile.color_bits);
    std::uint16_t bits = 0;  // of all values
    for (const Rgba& color : colors)
        for (const std::uint16_t v : color) bits |= v;
    if (bits <= max) return;
    for (const Rgba& color : colors)
        for (const std::uint16_t v : color)
            if (v > max)
                c.fail(fmt::format("colour value {}; expected at most {} (profile {})", v, max,
                                   c.profile.name));
}

void check_values(const Checker& c, const std::vector<std::uint32_t>& values, int bits) {
    const std::uint32_t max = max_of_bits(bits);
    for (const std::uint32_t v : values)
        if (v > max)
            c.fail(fmt::format("pixel value {}; expected at most {} (profile {})", v, max,
                               c.profile.name));
}

void check_depth(const Checker& c, std::uint32_t depth) {
    c.require(depth <= max_of_bits(c.depth_bits), "depth", depth, "a value of the depth plane");
}

/// The plane of a copy or a rectangle.
void check_plane(const Checker& c, Plane plane) {
    c.enumeration("plane", plane, Plane::Accum);
    c.require(plane != Plane::Accum, "plane", "Accum", "Color, Depth or Stencil");
}

void check_size(const Checker& c, const Rect& r) {
    const char* const expected = c.sides("0 to 4096", "0 to 8192");
    c.require(c.is_side(0, r.width), "rect.width", r.width, expected);
    c.require(c.is_side(0, r.height), "rect.height", r.height, expected);
}

void check_inside(const Checker& c, const Rect& r) {
    check_size(c, r);
    if (r.x < 0 || r.y < 0 || r.x > c.width - r.width || r.y > c.height - r.height)
        c.fail(fmt::format("rect = {} {} {} {}; expected one inside the window", r.x, r.y, r.width,
                           r.height));
}

}  // namespace

void check(const Checker& c, const WriteSpans& w) {
    check_colors(c, w.colors);
    check_depth(c, w.depth);
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

void check(const Checker& c, const WritePixels& w) {
    check_size(c, w.rect);
    c.position("rect.x", w.rect.x);
    c.position("rect.y", w.rect.y);
    check_colors(c, w.colors);
    check_plane(c, w.plane);
    const std::size_t given = w.plane == Plane::Color ? w.colors.size() : w.values.size();
    c.require(given == w.rect.area(), "pixels given", given, "width times height");
    check_depth(c, w.depth);
    check_values(c, w.values, w.plane == Plane::Stencil ? c.profile.stencil_bits : c.depth_bits);
}

void check(const Checker& c, const Copy& copy) {
    check_size(c, copy.source);
    check_plane(c, copy.plane);
    for (const int v : {copy.source.x, copy.source.y, copy.x, copy.y})
        c.position("copy position", v);
}

void check(const Checker& c, const CopyTexture& copy) {
    check_inside(c, copy.rect);
    c.require(copy.slot < 256, "slot", copy.slot, "0 to 255");
    c.require(copy.plane == Plane::Color || copy.plane == Plane::Depth, "plane", int(copy.plane),
              "Color or Depth");
    const bool any = c.profile.extensions.texture_sizes;
    const auto fits = [&](int side) {
        return any ? side > 0 : std::has_single_bit(unsigned(side));
    };
    const char* const expected = any ? "1 or more" : "a power of two";
    c.require(fits(copy.rect.width), "rect.width", copy.rect.width, expected);
    c.require(fits(copy.rect.height), "rect.height", copy.rect.height, expected);
}

void check(const Checker& c, const Read& read) {
    check_inside(c, read.rect);
    c.enumeration("plane", read.plane, Plane::Accum);
    if (!read.packed) return;
    c.require(read.plane == Plane::Color, "plane of packed pixels", int(read.plane), "Color");
    c.require(c.profile.color_bits <= 8, "color_bits of packed pixels", c.profile.color_bits,
              "at most 8");
}

namespace {

void check_raster(const Checker& c, const RasterPosition& r) {
    c.finite("raster.x", r.x);
    c.finite("raster.y", r.y);
    check_depth(c, r.depth);
    check_colors(c, {r.color, r.secondary_color});
    c.finite("raster.texcoord", r.texcoord);
    for (const vec4& v : r.more_texcoords) c.finite("raster.more_texcoords", v);
    c.require(r.distance >= 0 && std::isfinite(r.distance), "raster.distance", r.distance,
              "0 or more");
    c.finite("raster.fog_coordinate", r.fog_coordinate);
}

/// The pixels of a rectangle: all of a kind, or none.
void check_given(const Checker& c, const DrawPixels& d) {
    const auto all_or_none = [&](const char* what, std::size_t given, std::size_t all) {
        c.require(given == 0 || given == all, what, given, "one for each pixel, or none");
    };
    all_or_none("colors given", d.colors.size(), d.area());
    all_or_none("depths given", d.depths.size(), d.area());
    all_or_none("stencil values given", d.stencils.size(), d.area());
    c.require(d.bits.empty() || d.bits.size() == d.bit_row() * std::size_t(d.height),
              "bytes of bits given", d.bits.size(), "whole bytes for each row, or none");
    const bool fragments = !d.colors.empty() || !d.depths.empty();
    if (fragments && !d.stencils.empty())
        c.fail("stencil values with colours or depths; expected one of the two");
    if (d.source && (fragments || !d.stencils.empty()))
        c.fail("both a source and values; expected one of them");
}

}  // namespace

void check(const Checker& c, const DrawPixels& d) {
    c.extension(true, c.profile.extensions.draw_pixels, "draw_pixels");
    check_size(c, {0, 0, d.width, d.height});
    check_raster(c, d.raster);
    c.finite("zoom_x", d.zoom_x);
    c.finite("zoom_y", d.zoom_y);
    check_given(c, d);
    check_colors(c, d.colors);
    check_values(c, d.depths, c.depth_bits);
    check_values(c, d.stencils, c.profile.stencil_bits);
    check(c, d.map);
    if (d.more_maps) check(c, *d.more_maps);
    if (!d.source) return;
    check_plane(c, d.source->plane);
    c.position("copy position", d.source->x);
    c.position("copy position", d.source->y);
}

void check(const Checker& c, const Accumulate& a) {
    c.enumeration("op", a.op, AccumOp::Return);
    c.finite("value", a.value);
}

void check(const Checker& c, const SwapBuffers&) {
    c.require(c.profile.color_planes == 2, "color_planes", c.profile.color_planes, "2");
}

void check(const Checker& c, const Query&) {
    c.extension(true, c.profile.extensions.occlusion_query, "occlusion_query");
}

void check(const Checker& c, const BeginPass& pass) {
    if ((pass.digests & ~planes_of(c.profile)) == 0) return;
    const bool two = c.profile.color_planes == 2;
    c.fail(fmt::format("digests = {}; expected bits of {} planes, 0 to {}", pass.digests,
                       two ? "five" : "four", planes_of(c.profile)));
}

void check(const Checker& c, const Clear& clear) {
    c.planes("planes", clear.planes);
    c.finite("color", clear.color);
    c.finite("depth", clear.depth);
    c.finite("accum", clear.accum);
}

}  // namespace gw
