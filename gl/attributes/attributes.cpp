// PushAttrib .. PopClientAttrib. [GL11] 6.1.10
#include "gl/attributes/attributes.h"

#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/state/capabilities.h"

namespace gw::gl {

namespace {

/// The groups of the state and their bits.
void copy_groups(State& to, const State& from, GLbitfield mask) {
    if (mask & GL_CURRENT_BIT) to.current = from.current;
    if (mask & GL_POINT_BIT) to.point = from.point;
    if (mask & GL_LINE_BIT) to.line = from.line;
    if (mask & GL_POLYGON_BIT) to.polygon = from.polygon;
    if (mask & GL_POLYGON_STIPPLE_BIT) to.polygon_stipple = from.polygon_stipple;
    if (mask & GL_PIXEL_MODE_BIT) to.pixel = from.pixel;
    if (mask & GL_LIGHTING_BIT) to.lighting = from.lighting;
    if (mask & GL_FOG_BIT) to.fog = from.fog;
    if (mask & GL_DEPTH_BUFFER_BIT) to.depth = from.depth;
    if (mask & GL_ACCUM_BUFFER_BIT) to.accum = from.accum;
    if (mask & GL_STENCIL_BUFFER_BIT) to.stencil = from.stencil;
    if (mask & GL_VIEWPORT_BIT) to.viewport = from.viewport;
    if (mask & GL_TRANSFORM_BIT) to.transform = from.transform;
    if (mask & GL_COLOR_BUFFER_BIT) to.color_buffer = from.color_buffer;
    if (mask & GL_HINT_BIT) to.hint = from.hint;
    if (mask & GL_EVAL_BIT) to.eval = from.eval;
    if (mask & GL_LIST_BIT) to.list = from.list;
    if (mask & GL_TEXTURE_BIT) to.texture = from.texture;
    if (mask & GL_SCISSOR_BIT) to.scissor = from.scissor;
    if (mask & GL_MULTISAMPLE_BIT) to.multisample = from.multisample;
}

void save_enables(SavedAttributes& saved, State& s) {
    for_each_switch(s, [&](bool is_on) { saved.enables.push_back(is_on); });
}
void restore_enables(State& s, const SavedAttributes& saved) {
    std::size_t i = 0;
    for_each_switch(s, [&](bool& field) { field = saved.enables[i++]; });
}

void save_textures(SavedAttributes& saved, const Context& context) {
    for (std::size_t unit = 0; unit < texture_unit_count; ++unit)
        for (std::size_t target = 0; target < texture_target_count; ++target)
            saved.textures[unit][target] = context.textures.bound[unit][target]->parameters;
}
/// PopAttrib binds the textures again that were bound, as far as they still exist.
void restore_textures(Context& context, const SavedAttributes& saved) {
    for (std::size_t unit = 0; unit < texture_unit_count; ++unit) {
        context.state.texture.active = unit;
        for (std::size_t target = 0; target < texture_target_count; ++target) {
            if (!has_target(context.profile, target)) continue;
            execute::bind_texture(context, texture_targets[target],
                                  saved.state.texture.units[unit].bound[target]);
            TextureObject& object = *context.textures.bound[unit][target];
            if (object.parameters == saved.textures[unit][target]) continue;
            begin_change(context);
            object.set_parameters(saved.textures[unit][target]);
        }
    }
}

constexpr GLbitfield known_client_groups = GL_CLIENT_PIXEL_STORE_BIT | GL_CLIENT_VERTEX_ARRAY_BIT;

void copy_client_groups(ClientState& to, const ClientState& from, GLbitfield mask) {
    if (mask & GL_CLIENT_VERTEX_ARRAY_BIT) {
        to.arrays = from.arrays;
        to.active_unit = from.active_unit;
        to.array_buffer = from.array_buffer;
        to.element_buffer = from.element_buffer;
    }
    if (mask & GL_CLIENT_PIXEL_STORE_BIT) {
        to.pack = from.pack;
        to.unpack = from.unpack;
    }
}

bool is_of_object(GLenum buffer) { return buffer == GL_COLOR_ATTACHMENT0 || buffer == GL_NONE; }

/// The buffers are those of the bound framebuffers, which may not be those that were bound when the
/// attributes were pushed.
void keep_buffers(const Context& context, State& next) {
    const Framebuffers& f = context.framebuffers;
    GLenum& draw = next.color_buffer.draw_buffer;
    GLenum& read = next.pixel.read_buffer;
    if (f.draw ? !is_of_object(draw) : draw == GL_COLOR_ATTACHMENT0)
        draw = context.state.color_buffer.draw_buffer;
    if (f.read ? !is_of_object(read) : read == GL_COLOR_ATTACHMENT0)
        read = context.state.pixel.read_buffer;
    if (f.draw) f.draw->draw_buffer = draw;
    if (f.read) f.read->read_buffer = read;
}

/// Whether what was assembled may be drawn with either state: its vertices have their current
/// values and materials.
bool draw_alike(State a, const State& b) {
    a.current = b.current;
    a.lighting.material = b.lighting.material;
    a.transform.matrix_mode = b.transform.matrix_mode;
    a.texture.active = b.texture.active;
    return a == b;
}

}  // namespace

void copy_attributes(Context& to, const Context& from, GLbitfield mask) {
    copy_groups(to.state, from.state, mask);
    if (mask & GL_ENABLE_BIT) {
        SavedAttributes saved;
        State copied = from.state;
        save_enables(saved, copied);
        restore_enables(to.state, saved);
    }
    to.translated.stale = all_state_parts;
    if (!(mask & GL_TEXTURE_BIT)) return;
    for (std::size_t unit = 0; unit < texture_unit_count; ++unit)
        for (std::size_t i = 0; i < texture_target_count; ++i) {
            GLuint& name = to.state.texture.units[unit].bound[i];
            const bool has = name != 0 && to.shared == from.shared;
            to.textures.bound[unit][i] =
                has ? from.textures.bound[unit][i] : to.textures.initial[i];
            if (!has) name = 0;
        }
}

namespace execute {

void push_attrib(Context& context, GLbitfield mask) {
    if (context.attribute_stack.size() >= attribute_stack_depth)
        return set_error(context, GL_STACK_OVERFLOW);
    track_color(context);
    SavedAttributes& saved = context.attribute_stack.emplace_back();
    saved.mask = mask;
    copy_groups(saved.state, context.state, mask);
    if (mask & GL_ENABLE_BIT) save_enables(saved, context.state);
    if (mask & GL_TEXTURE_BIT) save_textures(saved, context);
}

void pop_attrib(Context& context) {
    if (context.attribute_stack.empty()) return set_error(context, GL_STACK_UNDERFLOW);
    track_color(context);
    const SavedAttributes saved = std::move(context.attribute_stack.back());
    context.attribute_stack.pop_back();
    if (saved.mask & GL_TEXTURE_BIT) restore_textures(context, saved);
    State next = context.state;
    copy_groups(next, saved.state, saved.mask);
    keep_buffers(context, next);
    if (saved.mask & GL_ENABLE_BIT) restore_enables(next, saved);
    if (!draw_alike(next, context.state)) begin_change(context);
    if (next.lighting.material != context.state.lighting.material)
        context.assembler.material_changed = true;
    context.state = std::move(next);
    track_color(context);
}

void push_client_attrib(Context& context, GLbitfield mask) {
    if (context.client_stack.size() >= client_stack_depth)
        return set_error(context, GL_STACK_OVERFLOW);
    SavedClientState& saved = context.client_stack.emplace_back();
    saved.mask = mask & known_client_groups;
    copy_client_groups(saved.state, context.client, saved.mask);
}

void pop_client_attrib(Context& context) {
    if (context.client_stack.empty()) return set_error(context, GL_STACK_UNDERFLOW);
    copy_client_groups(context.client, context.client_stack.back().state,
                       context.client_stack.back().mask);
    context.client_stack.pop_back();
}

}  // namespace execute

}  // namespace gw::gl
