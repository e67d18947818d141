#include "gw/plane_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gw {

const char* name_of(Plane plane) {
    switch (plane) {
        case Plane::Color: return "color";
        case Plane::Depth: return "depth";
        case Plane::Stencil: return "stencil";
        case Plane::Accum: return "accum";
    }
    return "";
}

std::string value_at(const Planes& p, Plane plane, int x, int y) {
    const std::size_t i = p.index(x, y);
    switch (plane) {
        case Plane::Color: return fmt::format("{}", fmt::join(p.color[i], " "));
        case Plane::Depth: return std::to_string(p.depth[i]);
        case Plane::Stencil: return std::to_string(p.stencil[i]);
        case Plane::Accum: return fmt::format("{}", fmt::join(p.accum[i], " "));
    }
    return "";
}

}  // namespace gw
