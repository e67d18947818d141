#include "inspect/text/value_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gw::inspect {

std::string text(bool v) { return v ? "on" : "off"; }
std::string text(int v) { return std::to_string(v); }
std::string text(std::uint32_t v) { return std::to_string(v); }
std::string text(float v) { return fmt::format("{}", v); }
std::string text(double v) { return fmt::format("{}", v); }
std::string text(const std::string& v) { return "'" + v + "'"; }

std::string text(const vec2& v) { return fmt::format("{} {}", v.x, v.y); }
std::string text(const vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string text(const vec4& v) { return fmt::format("{} {} {} {}", v.x, v.y, v.z, v.w); }
std::string text(const dvec4& v) { return fmt::format("{} {} {} {}", v.x, v.y, v.z, v.w); }
std::string text(const dmat4& m) {
    std::string rows;
    for (int row = 0; row < 4; ++row)
        rows += (row ? "; " : "") + text(dvec4(m[0][row], m[1][row], m[2][row], m[3][row]));
    return rows;
}
std::string text(const Rgba& c) { return fmt::format("{}", fmt::join(c, " ")); }
std::string text(const Rect& r) { return fmt::format("{} {} {} {}", r.x, r.y, r.width, r.height); }
std::string text(const Span& s) {
    return fmt::format("x {} y {} length {} first {}{}", s.x, s.y, s.length, s.first,
                       s.flat ? " flat" : "");
}
std::string text(const RasterPosition& r) {
    std::string out = fmt::format("x {} y {} depth {} color {} texcoord {} distance {}", r.x, r.y,
                                  r.depth, text(r.color), text(r.texcoord), r.distance);
    if (r.more_texcoords != initial_texcoords) out += " more_texcoords " + text(r.more_texcoords);
    return out;
}
std::string text(const MoreTexcoords& v) {
    return fmt::format("{}; {}; {}", text(v[0]), text(v[1]), text(v[2]));
}
std::string text(const std::optional<PixelSource>& s) {
    return s ? fmt::format("{} {} {}", text(s->plane), s->x, s->y) : "none";
}
std::string text(const std::optional<SurfacePlane>& s) {
    return s ? fmt::format("{} of surface {}", text(s->plane), s->surface) : "none";
}
std::string text(const Surface& s) {
    const std::string samples = s.samples != 0 ? fmt::format(" samples {}", s.samples) : "";
    return fmt::format("{} x {} planes {} depth_bits {}{}", s.width, s.height, int(s.planes),
                       s.depth_bits, samples);
}
std::string text(const Material& m) {
    return fmt::format("Ka {} Kd {} Ks {} Ke {} Ns {} alpha {}", text(m.Ka), text(m.Kd), text(m.Ks),
                       text(m.Ke), m.Ns, m.alpha);
}
std::string text(const FaceMaterials& m) { return text(m.front) + ", back " + text(m.back); }
std::string text(const ColorMask& m) {
    return std::string(m.r ? "r" : "-") + (m.g ? "g" : "-") + (m.b ? "b" : "-") + (m.a ? "a" : "-");
}
std::string text(const std::optional<std::uint32_t>& v) { return v ? std::to_string(*v) : "none"; }

}  // namespace gw::inspect
