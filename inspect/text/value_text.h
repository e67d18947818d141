// Values of commands and states as text: numbers in full precision, enumerations by GL's words.
// Does not name the values.
#pragma once

#include "gw/command_list.h"
#include "gw/describe/enumerators.h"

#include <string>
#include <type_traits>

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
std::string text(const RasterPosition& r);  ///< "x 4 y 2.5 depth 0 ..."
std::string text(const MoreTexcoords& v);
std::string text(const std::optional<PixelSource>& s);   ///< "Color 4 2"; "none"
std::string text(const std::optional<SurfacePlane>& s);  ///< "Depth of surface 4"; "none"
std::string text(const Surface& s);                      ///< "64 x 32 planes 7 depth_bits 0"
std::string text(const Material& m);                     ///< "Ka 0.2 0.2 0.2 Kd ..."
std::string text(const FaceMaterials& m);
std::string text(const ColorMask& m);                     ///< "rg-a"
std::string text(const std::optional<std::uint32_t>& v);  ///< "none" if there is none

/// "OneMinusSrcAlpha"; "" if no enumerator has the value.
template <class Enum>
requires std::is_enum_v<Enum> std::string text(Enum v) { return std::string(enumerator(v)); }

}  // namespace gw::inspect
