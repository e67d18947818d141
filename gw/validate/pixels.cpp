// Checks commands on pixels: their rectangles, spans, values and planes. BeginPass: its digests.
#include "gw/validate/checker.h"

#include <bit>

namespace gw {
namespace {

void check_colors(const Checker& c, const std::vector<Rgba>& colors) {
    const std::uint32_t max = max_of_bits(c.profile.color_bits);
    for (const Rgba& color : colors)
        for (const std::uint16_t v : color)
            if (v > max)
                c.fail(fmt::format("colour value {}; expected at most {} (profile {})", v, max,
                                   c.profile.name));
}

void check_size(const Checker& c, const Rect& r) {
    c.require(r.width >= 0 && r.width <= max_window_size, "rect.width", r.width, "0 to 4096");
    c.require(r.height >= 0 && r.height <= max_window_size, "rect.height", r.height, "0 to 4096");
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

void check(const Checker& c, const WritePixels& w) {
    check_size(c, w.rect);
    c.position("rect.x", w.rect.x);
    c.position("rect.y", w.rect.y);
    check_colors(c, w.colors);
    c.enumeration("plane", w.plane, Plane::Accum);
    c.require(w.plane != Plane::Accum, "plane", "Accum", "Color, Depth or Stencil");
    const std::size_t given = w.plane == Plane::Color ? w.colors.size() : w.values.size();
    c.require(given == w.rect.area(), "pixels given", given, "width times height");
    const std::uint32_t max =
        max_of_bits(w.plane == Plane::Stencil ? c.profile.stencil_bits : c.profile.depth_bits);
    c.require(w.depth <= max_of_bits(c.profile.depth_bits), "depth", w.depth,
              "a value of the depth plane");
    for (const std::uint32_t v : w.values)
        if (v > max)
            c.fail(fmt::format("pixel value {}; expected at most {} (profile {})", v, max,
                               c.profile.name));
}

void check(const Checker& c, const Copy& copy) {
    check_size(c, copy.source);
    c.enumeration("plane", copy.plane, Plane::Accum);
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
    c.enumeration("plane", read.plane, Plane::Accum);
    if (!read.packed) return;
    c.require(read.plane == Plane::Color, "plane of packed pixels", int(read.plane), "Color");
    c.require(c.profile.color_bits <= 8, "color_bits of packed pixels", c.profile.color_bits,
              "at most 8");
}

void check(const Checker& c, const Accumulate& a) {
    c.enumeration("op", a.op, AccumOp::Return);
    c.finite("value", a.value);
}

void check(const Checker& c, const BeginPass& pass) { c.planes("digests", pass.digests); }

void check(const Checker& c, const Clear& clear) {
    c.planes("planes", clear.planes);
    c.finite("color", clear.color);
    c.finite("depth", clear.depth);
}

}  // namespace gw
