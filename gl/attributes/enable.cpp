// Enable and Disable. [GL11] 6.1
#include "gl/api/calls.h"
#include "gl/attributes/attributes.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/state/capabilities.h"

namespace gw::gl {

namespace {

void set_capability(Context& c, GLenum name, bool on) {
    const Capability* const capability = find_capability(name);
    // GL_EXT_vertex_array: arrays are enabled as other capabilities are.
    if (ClientArray* const array = find_array(c.client, name)) {
        array->enable = on;
        return;
    }
    if (capability == nullptr) return set_error(c, GL_INVALID_ENUM);
    if (name == GL_COLOR_MATERIAL) track_color(c);
    change(c, capability->field(c.state, capability->index), on);
    if (name == GL_COLOR_MATERIAL) track_color(c);
}

}  // namespace

namespace execute {

void enable(Context& c, GLenum cap) { set_capability(c, cap, true); }
void disable(Context& c, GLenum cap) { set_capability(c, cap, false); }

GLboolean is_enabled(Context& c, GLenum cap) {
    const Capability* const capability = find_capability(cap);
    if (capability != nullptr) return gl::is_enabled(c.state, *capability) ? GL_TRUE : GL_FALSE;
    if (const ClientArray* array = find_array(c.client, cap)) return array->enable;
    return set_error(c, GL_INVALID_ENUM), GL_FALSE;
}

}  // namespace execute

}  // namespace gw::gl
