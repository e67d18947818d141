// The groups of the state as wholes, for other rooms. The calls that set them: gl/api/calls.h.
#pragma once

#include <GL/gl.h>

namespace gw::gl {

struct Context;

/// Copies the groups of PushAttrib's bits from a context to one that is not current. Bindings of
/// textures are copied as far as both share them. [GLX 1.4] 3.3.7, CopyContext
void copy_attributes(Context& to, const Context& from, GLbitfield mask);

/// COLOR_MATERIAL: brings the material parameter that follows the current colour up to it. [GL11]
/// 2.13.3. Called before materials are queried or saved, and before the parameter that follows
/// changes; draws follow the colours of their vertices.
void track_color(Context& context);

}  // namespace gw::gl
