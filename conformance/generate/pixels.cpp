#include "conformance/generate/pixels.h"

#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"
#include "gw/base/arithmetic.h"

#include <algorithm>
#include <bit>

namespace gw::conformance {
namespace {

std::uint32_t any_value(Random& r, int bits) {
    const int kind = r.below(10);
    if (kind < 2) return 0;
    if (kind < 4) return max_of_bits(bits);
    return kind < 6 ? max_of_bits(bits) / 2 : r.bits(bits);
}

/// A rectangle, sometimes partly outside the window.
Rect any_rect(Random& r, const Case& w) {
    Rect rect{r.between(-4, w.width), r.between(-4, w.height), r.between(0, w.width + 6),
              r.between(0, w.height + 6)};
    if (r.chance(50)) rect.width = std::min(rect.width, 17);
    return rect;
}

Rect any_inner_rect(Random& r, const Case& w) {
    if (r.chance(20)) return {0, 0, w.width, w.height};
    Rect rect{r.below(w.width), r.below(w.height)};
    rect.width = r.between(r.chance(5) ? 0 : 1, w.width - rect.x);
    rect.height = r.between(r.chance(5) ? 0 : 1, w.height - rect.y);
    return rect;
}

/// Zooms whose edges meet centres of pixels, and any others.
double any_zoom(Random& r) {
    const double size = r.chance(60) ? r.pick({1.0, 1.0, 0.5, 1.5, 2.0, 3.0, 0.25, 0.0})
                                     : r.real(0, r.chance(90) ? 4 : 1e6);
    return r.chance(30) ? -size : size;
}

RasterPosition any_raster_position(Random& r, const Case& w) {
    RasterPosition out;
    out.x = r.chance(60) ? r.between(-4, w.width) : r.real(-20, w.width + 20);
    out.y = r.chance(60) ? r.between(-4, w.height) + r.pick({0.0, 0.5}) : r.real(-20, w.height);
    out.depth = any_value(r, w.profile.depth_bits);
    out.color = any_pixel(r, w.profile.color_bits);
    out.texcoord = {float(r.real(-2, 2)), float(r.real(-2, 2)), float(r.real(-1, 2)), 1};
    if (r.chance(30)) out.texcoord.w = float(r.chance(80) ? r.real(0.1, 3) : r.real(-1, 0));
    out.distance = r.chance(80) ? r.real(0, 20) : r.pick({0.0, 1e30});
    return out;
}

std::vector<std::uint32_t> any_values(Random& r, std::size_t count, int bits) {
    std::vector<std::uint32_t> out(count);
    for (std::uint32_t& v : out) v = any_value(r, bits);
    return out;
}

/// Colours, depths, both or none; or stencil values; or a source.
void give_values(Random& r, const Case& w, DrawPixels& d) {
    const Profile& p = w.profile;
    const int kind = r.below(100);
    if (kind < 30)
        d.source = {r.pick({Plane::Color, Plane::Depth, Plane::Stencil}), r.between(-5, w.width),
                    r.between(-5, w.height)};
    else if (kind < 42)
        d.stencils = any_values(r, d.area(), p.stencil_bits);
    else if (kind < 85) {
        if (r.chance(75))
            for (std::size_t i = 0; i < d.area(); ++i)
                d.colors.push_back(any_pixel(r, p.color_bits));
        if (r.chance(40)) d.depths = any_values(r, d.area(), p.depth_bits);
    }
    if (kind >= 85 || r.chance(20))
        for (std::size_t i = 0; i < d.bit_row() * std::size_t(d.height); ++i)
            d.bits.push_back(std::uint8_t(r.bits(8)));
}

}  // namespace

Rgba any_pixel(Random& r, int color_bits) {
    Rgba out;
    for (std::uint16_t& v : out) v = static_cast<std::uint16_t>(any_value(r, color_bits));
    return out;
}

Clear any_clear(Random& r) {
    Clear c;
    c.planes = static_cast<PlaneMask>(r.below(16));
    c.color = any_color(r);
    c.depth = r.chance(60) ? 1 : r.chance(50) ? 0.5 : r.real(-0.5, 1.5);
    c.stencil = r.chance(60) ? r.below(4) : r.between(-300, 300);
    return c;
}

WriteSpans any_spans(Random& r, const Case& w) {
    WriteSpans out;
    const int colors = r.between(1, 40);
    for (int i = 0; i < colors; ++i) out.colors.push_back(any_pixel(r, w.profile.color_bits));
    const int spans = r.between(0, 12);
    for (int i = 0; i < spans; ++i) {
        Span s{r.between(-3, w.width), r.between(-1, w.height)};
        s.flat = r.chance(50);
        s.first = std::uint32_t(r.below(colors));
        s.length = s.flat ? r.between(0, w.width + 3) : r.between(0, colors - int(s.first));
        out.spans.push_back(s);
    }
    if (r.chance(5)) out.spans.push_back({-4096, 0, 2147483647, 0, true});
    out.depth = any_value(r, w.profile.depth_bits);
    return out;
}

WritePixels any_pixels(Random& r, const Case& w) {
    WritePixels out{any_rect(r, w),
                    r.pick({Plane::Color, Plane::Color, Plane::Depth, Plane::Stencil})};
    const int count = out.rect.width * out.rect.height;
    const bool constant = r.chance(20);
    if (out.plane == Plane::Color) {
        const Rgba all = any_pixel(r, w.profile.color_bits);
        for (int i = 0; i < count; ++i)
            out.colors.push_back(constant ? all : any_pixel(r, w.profile.color_bits));
    } else {
        const int bits = out.plane == Plane::Depth ? w.profile.depth_bits : w.profile.stencil_bits;
        for (int i = 0; i < count; ++i) out.values.push_back(any_value(r, bits));
    }
    out.depth = any_value(r, w.profile.depth_bits);
    return out;
}

Accumulate any_accumulate(Random& r, const Profile& p) {
    Accumulate a{r.any(AccumOp::Return)};
    const int kind = r.below(10);
    const float large = float(1 << (p.accum_bits - p.color_bits - 1 > 20 ? 20 : p.accum_bits - 8));
    if (kind < 4) a.value = 1;
    if (kind == 4) a.value = 1.0f / float(r.between(1, 16));
    if (kind == 5) a.value = float(r.real(-2, 2));
    if (kind == 6) a.value = float(r.between(-4, 4));
    if (kind == 7) a.value = float(r.between(1, 9)) / 2;  // ties
    if (kind == 8) a.value = large * float(r.real(-1, 1));
    if (kind == 9) a.value = r.pick({0.0f, -1.0f, 1e30f, -1e30f, 1e-30f, 0.5f});
    return a;
}

Copy any_copy(Random& r, const Case& w) {
    Copy c{r.pick({Plane::Color, Plane::Depth, Plane::Stencil}), any_rect(r, w)};
    c.x = r.between(-w.width, w.width);
    c.y = r.between(-w.height, w.height);
    if (r.chance(40)) {  // a small overlap
        c.x = c.source.x + r.between(-3, 3);
        c.y = c.source.y + r.between(-3, 3);
    }
    return c;
}

Read any_read(Random& r, const Case& w) {
    Read read{std::uint32_t(r.below(5)), r.any(Plane::Accum), any_inner_rect(r, w)};
    read.packed = read.plane == Plane::Color && w.profile.color_bits <= 8 && read.key % 2 == 1;
    return read;
}

DrawPixels any_draw_pixels(Script& s) {
    Random& r = s.random;
    DrawPixels d{.width = r.between(0, 24),
                 .height = r.between(0, 24),
                 .raster = any_raster_position(r, s.out),
                 .zoom_x = any_zoom(r),
                 .zoom_y = any_zoom(r)};
    give_values(r, s.out, d);
    if (r.chance(35)) d.map = any_binding(s);
    return d;
}

void copy_texture(Script& s, Plane plane) {
    Random& r = s.random;
    const int width = s.out.width, height = s.out.height;
    Rect rect;
    rect.width = 1 << r.below(std::bit_width(unsigned(width)));
    rect.height = 1 << r.below(std::bit_width(unsigned(height)));
    rect.x = r.between(0, width - rect.width);
    rect.y = r.between(0, height - rect.height);
    const auto slot = std::uint32_t(r.chance(90) ? r.below(3) : 255);
    std::erase(s.color_slots, slot);
    std::erase(s.depth_slots, slot);
    (plane == Plane::Color ? s.color_slots : s.depth_slots).push_back(slot);
    add(s, CopyTexture{slot, plane, rect});
}

}  // namespace gw::conformance
