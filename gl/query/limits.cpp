// The limits of this implementation, as state variables.
#include "gl/query/state_variables.h"

#include "gl/context/context.h"
#include "gl/draw/targets.h"

namespace gw::gl {

namespace {

/// The bits of what is drawn to.
struct DrawBits {
    int color, alpha, stencil;
};
DrawBits draw_bits(const Context& context) {
    const Profile& p = context.profile;
    const FramebufferRef& framebuffer = context.framebuffers.draw;
    if (!framebuffer) return {p.color_bits, p.color_bits, p.stencil_bits};
    const auto color = attached_image(framebuffer->at(Plane::Color));
    const auto stencil = attached_image(framebuffer->at(Plane::Stencil));
    return {color ? p.color_bits : 0,
            color && base_format(color->internal_format) == GL_RGBA ? p.color_bits : 0,
            stencil ? p.stencil_bits : 0};
}

GLuint name_of(const FramebufferRef& framebuffer) { return framebuffer ? framebuffer->name : 0; }

/// The step of sizes and widths with antialiasing.
double size_step(const Profile& profile) { return profile.coverage_bits > 0 ? 0x1p-11 : 1; }

void add_framebuffer_objects(StateVariables& t) {
    t[GL_MAX_RENDERBUFFER_SIZE] = [](Context&) { return whole(max_surface_size); };
    t[GL_MAX_COLOR_ATTACHMENTS] = [](Context&) { return whole(1); };
    t[GL_MAX_SAMPLES] = [](Context& context) { return whole(most_samples(context)); };
    t[GL_DRAW_FRAMEBUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.framebuffers.draw));
    };
    t[GL_READ_FRAMEBUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.framebuffers.read));
    };
    t[GL_RENDERBUFFER_BINDING] = [](Context& context) {
        const RenderbufferRef& bound = context.framebuffers.renderbuffer;
        return whole(bound ? bound->name : 0u);
    };
}

}  // namespace

void add_limits(StateVariables& t) {
    t[GL_MAX_ELEMENTS_INDICES] = [](Context&) { return whole(1 << 16); };
    t[GL_MAX_ELEMENTS_VERTICES] = [](Context&) { return whole(1 << 16); };
    t[GL_MAX_LIGHTS] = [](Context&) { return whole(light_count); };
    t[GL_MAX_CLIP_PLANES] = [](Context&) { return whole(max_clip_planes); };
    t[GL_MAX_MODELVIEW_STACK_DEPTH] = [](Context&) { return whole(modelview_stack_depth); };
    t[GL_MAX_PROJECTION_STACK_DEPTH] = [](Context&) { return whole(projection_stack_depth); };
    t[GL_MAX_TEXTURE_STACK_DEPTH] = [](Context&) { return whole(texture_stack_depth); };
    t[GL_MAX_TEXTURE_SIZE] = [](Context& context) {
        return whole(largest_texture(context.profile));
    };
    t[GL_MAX_TEXTURE_UNITS] = [](Context& context) { return whole(unit_count(context.profile)); };
    t[GL_MAX_RECTANGLE_TEXTURE_SIZE] = [](Context& context) {
        return whole(largest_texture(context.profile, rectangular));
    };
    t[GL_MAX_3D_TEXTURE_SIZE] = [](Context& context) {
        return whole(largest_texture(context.profile, three_dimensions));
    };
    t[GL_MAX_CUBE_MAP_TEXTURE_SIZE] = [](Context& context) {
        return whole(largest_texture(context.profile, cube));
    };
    t[GL_MAX_TEXTURE_LOD_BIAS] = [](Context&) { return number(max_lod_bias); };
    t[GL_NUM_COMPRESSED_TEXTURE_FORMATS] = [](Context&) {
        return whole(compressed_texture_formats.size());
    };
    t[GL_COMPRESSED_TEXTURE_FORMATS] = [](Context&) {
        QueryValues out;
        for (const GLenum format : compressed_texture_formats) out.add(format);
        return out;
    };
    t[GL_MAX_PIXEL_MAP_TABLE] = [](Context&) { return whole(max_pixel_map); };
    t[GL_MAX_NAME_STACK_DEPTH] = [](Context&) { return whole(name_stack_depth); };
    t[GL_MAX_LIST_NESTING] = [](Context&) { return whole(max_list_nesting); };
    t[GL_MAX_EVAL_ORDER] = [](Context&) { return whole(max_eval_order); };
    t[GL_MAX_VIEWPORT_DIMS] = [](Context& context) {
        const int side = largest_viewport(context.profile);
        return wholes(side, side);
    };
    t[GL_MAX_ATTRIB_STACK_DEPTH] = [](Context&) { return whole(attribute_stack_depth); };
    t[GL_MAX_CLIENT_ATTRIB_STACK_DEPTH] = [](Context&) { return whole(client_stack_depth); };
    t[GL_SUBPIXEL_BITS] = [](Context& context) { return whole(context.profile.subpixel_bits); };
    for (const GLenum range : {GL_POINT_SIZE_RANGE, GL_ALIASED_POINT_SIZE_RANGE})
        t[range] = [](Context&) { return numbers_of(1, 128); };
    t[GL_POINT_SIZE_GRANULARITY] = [](Context& context) {
        return number(size_step(context.profile));
    };
    for (const GLenum range : {GL_LINE_WIDTH_RANGE, GL_ALIASED_LINE_WIDTH_RANGE})
        t[range] = [](Context&) { return numbers_of(1, 128); };
    t[GL_LINE_WIDTH_GRANULARITY] = [](Context& context) {
        return number(size_step(context.profile));
    };
    t[GL_SAMPLES] = [](Context& context) { return whole(draw_samples(context)); };
    t[GL_SAMPLE_BUFFERS] = [](Context& context) {
        return whole(draw_samples(context) > 0 ? 1 : 0);
    };
    t[GL_AUX_BUFFERS] = [](Context&) { return whole(0); };
    t[GL_RGBA_MODE] = [](Context&) { return whole(GL_TRUE); };
    t[GL_INDEX_MODE] = [](Context&) { return whole(GL_FALSE); };
    t[GL_STEREO] = [](Context&) { return whole(GL_FALSE); };
    t[GL_DOUBLEBUFFER] = [](Context& context) {
        return whole(!context.framebuffers.draw && context.window != nullptr &&
                     context.window->is_double_buffered());
    };
    for (const GLenum name : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS})
        t[name] = [](Context& context) { return whole(draw_bits(context).color); };
    t[GL_ALPHA_BITS] = [](Context& context) { return whole(draw_bits(context).alpha); };
    t[GL_INDEX_BITS] = [](Context&) { return whole(0); };
    t[GL_DEPTH_BITS] = [](Context& context) { return whole(draw_depth_bits(context)); };
    t[GL_STENCIL_BITS] = [](Context& context) { return whole(draw_bits(context).stencil); };
    for (const GLenum name :
         {GL_ACCUM_RED_BITS, GL_ACCUM_GREEN_BITS, GL_ACCUM_BLUE_BITS, GL_ACCUM_ALPHA_BITS})
        t[name] = [](Context& context) {
            return whole(context.framebuffers.draw ? 0 : context.profile.accum_bits);
        };
    add_framebuffer_objects(t);
}

}  // namespace gw::gl
