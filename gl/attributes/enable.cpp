// Enable and Disable. [GL11] 6.1
#include "gl/api/calls.h"
#include "gl/attributes/attributes.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/state/capabilities.h"

namespace gw::gl {

namespace {

void set_capability(Context& context, GLenum name, bool on) {
    const Capability* const capability = find_capability(context.profile, name);
    // GL_EXT_vertex_array: arrays are enabled as other capabilities are.
    if (ClientArray* const array = find_array(context.client, name)) {
        array->enable = on;
        return;
    }
    if (capability == nullptr) return set_error(context, GL_INVALID_ENUM);
    if (name == GL_COLOR_MATERIAL) track_color(context);
    change(context, capability->field(context.state, capability->index), on);
    if (name == GL_COLOR_MATERIAL) track_color(context);
}

}  // namespace

namespace execute {

void enable(Context& context, GLenum cap) { set_capability(context, cap, true); }
void disable(Context& context, GLenum cap) { set_capability(context, cap, false); }

GLboolean is_enabled(Context& context, GLenum cap) {
    const Capability* const capability = find_capability(context.profile, cap);
    if (capability != nullptr)
        return gl::is_enabled(context.state, *capability) ? GL_TRUE : GL_FALSE;
    if (const ClientArray* array = find_array(context.client, cap)) return array->enable;
    return set_error(context, GL_INVALID_ENUM), GL_FALSE;
}

}  // namespace execute

}  // namespace gw::gl
