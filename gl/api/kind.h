// When a function may be called, and whether a display list keeps it: gl/entry/functions.txt.
#pragma once

#include <cstdint>

namespace gw::gl {

enum class Kind : std::uint8_t { Vertex, State, Draw, Expand, Client, Now };

/// [GL11] 2.6.3: the functions that may stand between Begin and End.
constexpr bool may_stand_inside(Kind kind) {
    return kind == Kind::Vertex || kind == Kind::Client || kind == Kind::Expand;
}
/// [GL11] 5.4: the functions that a display list keeps.
constexpr bool is_listed(Kind kind) {
    return kind == Kind::Vertex || kind == Kind::State || kind == Kind::Draw;
}

}  // namespace gw::gl
