// Values of commands and states as text: numbers in full precision, enumerations by GL's words.
// Does not name the values.
#pragma once

#include "gw/command_list.h"

#include <string>

namespace gw::inspect {

std::string text(bool v);  ///< "on", "off"
std::string text(int v);
std::string text(std::uint32_t v);
std::string text(float v);
std::string text(double v);
std::string text(const std::string& v);  ///< in quotes

std::string text(const vec2& v);  ///< "1 0.5"
std::string text(const vec3& v);
std::string text(const vec4& v);
std::string text(const dvec4& v);
std::string text(const dmat4& m);  ///< rows, as matrices are written
std::string text(const Rgba& c);
std::string text(const Rect& r);  ///< "x y width height"
std::string text(const Span& s);
std::string text(const RasterPosition& r);              ///< "x 4 y 2.5 depth 0 ..."
std::string text(const std::optional<PixelSource>& s);  ///< "Color 4 2"; "none"
std::string text(const Material& m);                    ///< "Ka 0.2 0.2 0.2 Kd ..."
std::string text(const FaceMaterials& m);
std::string text(const ColorMask& m);                     ///< "rg-a"
std::string text(const std::optional<std::uint32_t>& v);  ///< "none" if there is none

std::string text(Primitive v);
std::string text(Plane v);
std::string text(AccumOp v);
std::string text(CompareFunc v);
std::string text(StencilOp v);
std::string text(BlendFactor v);
std::string text(BlendEquation v);
std::string text(LogicOp v);
std::string text(Face v);
std::string text(Winding v);
std::string text(PolygonMode v);
std::string text(ShadeModel v);
std::string text(ColorSource v);
std::string text(ColorMaterial v);
std::string text(CoordinateMode v);
std::string text(TextureFormat v);
std::string text(FogMode v);
std::string text(FogCoordinate v);
std::string text(MinFilter v);
std::string text(MagFilter v);
std::string text(Wrap v);
std::string text(TexEnv v);
std::string text(TexGen v);
std::string text(DrawBuffer v);
std::string text(ReadBuffer v);

}  // namespace gw::inspect
