// COLOR_MATERIAL: a material parameter that follows the current colour. [GL11] 2.13.3
#pragma once

namespace gw::gl {

struct Context;

/// Brings the materials up to the current colour. Called before they are queried or saved, and
/// before the parameter that follows changes; draws follow the colours of their vertices.
void track_color(Context& c);

}  // namespace gw::gl
