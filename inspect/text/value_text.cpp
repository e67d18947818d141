#include "inspect/text/value_text.h"

#include "inspect/recording/file_values.h"

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
    return fmt::format("x {} y {} depth {} color {} texcoord {} distance {}", r.x, r.y, r.depth,
                       text(r.color), text(r.texcoord), r.distance);
}
std::string text(const std::optional<PixelSource>& s) {
    return s ? fmt::format("{} {} {}", text(s->plane), s->x, s->y) : "none";
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

std::string text(Primitive v) { return gwt::EnumNamePrimitive(file_enum<gwt::Primitive>(v)); }
std::string text(Plane v) { return gwt::EnumNamePlane(file_enum<gwt::Plane>(v)); }
std::string text(AccumOp v) { return gwt::EnumNameAccumOp(file_enum<gwt::AccumOp>(v)); }
std::string text(CompareFunc v) { return gwt::EnumNameCompareFunc(file_enum<gwt::CompareFunc>(v)); }
std::string text(StencilOp v) { return gwt::EnumNameStencilOp(file_enum<gwt::StencilOp>(v)); }
std::string text(BlendFactor v) { return gwt::EnumNameBlendFactor(file_enum<gwt::BlendFactor>(v)); }
std::string text(BlendEquation v) {
    return gwt::EnumNameBlendEquation(file_enum<gwt::BlendEquation>(v));
}
std::string text(LogicOp v) { return gwt::EnumNameLogicOp(file_enum<gwt::LogicOp>(v)); }
std::string text(Face v) { return gwt::EnumNameFace(file_enum<gwt::Face>(v)); }
std::string text(Winding v) { return gwt::EnumNameWinding(file_enum<gwt::Winding>(v)); }
std::string text(PolygonMode v) { return gwt::EnumNamePolygonMode(file_enum<gwt::PolygonMode>(v)); }
std::string text(ShadeModel v) { return gwt::EnumNameShadeModel(file_enum<gwt::ShadeModel>(v)); }
std::string text(ColorSource v) { return gwt::EnumNameColorSource(file_enum<gwt::ColorSource>(v)); }
std::string text(ColorMaterial v) {
    return gwt::EnumNameColorMaterial(file_enum<gwt::ColorMaterial>(v));
}
std::string text(CoordinateMode v) {
    return gwt::EnumNameCoordinateMode(file_enum<gwt::CoordinateMode>(v));
}
std::string text(TextureFormat v) {
    return gwt::EnumNameTextureFormat(file_enum<gwt::TextureFormat>(v));
}
std::string text(FogMode v) { return gwt::EnumNameFogMode(file_enum<gwt::FogMode>(v)); }
std::string text(FogCoordinate v) {
    return gwt::EnumNameFogCoordinate(file_enum<gwt::FogCoordinate>(v));
}
std::string text(MinFilter v) { return gwt::EnumNameMinFilter(file_enum<gwt::MinFilter>(v)); }
std::string text(MagFilter v) { return gwt::EnumNameMagFilter(file_enum<gwt::MagFilter>(v)); }
std::string text(Wrap v) { return gwt::EnumNameWrap(file_enum<gwt::Wrap>(v)); }
std::string text(TexEnv v) { return gwt::EnumNameTexEnv(file_enum<gwt::TexEnv>(v)); }
std::string text(TexGen v) { return gwt::EnumNameTexGen(file_enum<gwt::TexGen>(v)); }
std::string text(DrawBuffer v) { return gwt::EnumNameDrawBuffer(file_enum<gwt::DrawBuffer>(v)); }
std::string text(ReadBuffer v) { return gwt::EnumNameReadBuffer(file_enum<gwt::ReadBuffer>(v)); }

}  // namespace gw::inspect
