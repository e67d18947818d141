// Checks MakeSurface, UseSurface and Blit: their numbers, sizes and planes. Which surfaces there are,
// list.cpp knows.
#include "gw/validate/checker.h"

namespace gw {
namespace {

void check_number(const Checker& c, std::uint32_t number, std::uint32_t least,
                  const char* expected) {
    c.require(number >= least && number <= max_surfaces, "surface", number, expected);
}

void check_planes(const Checker& c, PlaneMask planes) {
    if ((planes & ~surface_planes) != 0)
        c.fail(
            fmt::format("planes = {}; expected bits of Color, Depth and Stencil, 0 to 7", planes));
}

void check_rect(const Checker& c, const char* what, const Rect& r) {
    const auto inside = [](int low, int v) { return v >= low && v <= max_surface_size; };
    const bool ok = inside(-max_surface_size, r.x) && inside(-max_surface_size, r.y) &&
                    inside(0, r.width) && inside(0, r.height);
    if (!ok)
        c.fail(fmt::format(
            "{} = {} {} {} {}; expected a corner of -8192 to 8192 and sides of 0 to 8192", what,
            r.x, r.y, r.width, r.height));
}

void check_samples(const Checker& c, const Surface& s) {
    if (s.samples == 0) return;
    c.extension(true, c.profile.extensions.multisample, "multisample");
    c.require(s.samples == 2 || s.samples == 4 || s.samples == 8, "surface.samples", s.samples,
              "0, 2, 4 or 8");
    c.require(c.profile.subpixel_bits >= 3, "subpixel_bits of samples", c.profile.subpixel_bits,
              "3 or more");
    const std::int64_t all = std::int64_t{s.width} * s.height * s.samples;
    c.require(all <= max_surface_samples, "samples of the surface", all, "at most 67108864");
}

}  // namespace

void check(const Checker& c, const MakeSurface& make) {
    c.extension(true, c.profile.extensions.surfaces, "surfaces");
    check_number(c, make.number, 1, "1 to 1023");
    const Surface& s = make.surface;
    check_planes(c, s.planes);
    const bool none = s.width == 0 && s.height == 0;
    c.require(none || c.is_side(1, s.width), "surface.width", s.width, "1 to 8192");
    c.require(none || c.is_side(1, s.height), "surface.height", s.height, "1 to 8192");
    c.require(s.depth_bits == 0 || (s.depth_bits >= 16 && s.depth_bits <= 32), "surface.depth_bits",
              s.depth_bits, "0, or 16 to 32");
    check_samples(c, s);
    if (!none && s.planes == 0) c.fail("a surface without planes; expected one or more");
}

void check(const Checker& c, const UseSurface& use) {
    c.extension(true, c.profile.extensions.surfaces, "surfaces");
    check_number(c, use.number, 0, "0 to 1023");
}

void check(const Checker& c, const Blit& blit) {
    c.extension(true, c.profile.extensions.surfaces, "surfaces");
    check_number(c, blit.from_surface, 0, "0 to 1023");
    check_planes(c, blit.planes);
    check_rect(c, "source", blit.source);
    check_rect(c, "target", blit.target);
    c.enumeration("filter", blit.filter, MagFilter::Linear);
}

}  // namespace gw
