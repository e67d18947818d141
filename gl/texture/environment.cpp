// TexEnv. [GL11] 3.8.9, [GL13] 3.8.12
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include "gw/describe/opengl.h"

namespace gw::gl {

namespace {

vec4 clamped_env_color(const Params& p) {
    vec4 out = p.as_vec4();
    for (int i = 0; i < 4; ++i) out[i] = clamped(out[i], 0.0f, 1.0f);
    return out;
}

/// A value of GL_COMBINE that the machine has a word for.
template <class Enum>
void set_word(Context& context, GLenum& field, GLenum value) {
    const auto word = from_opengl<Enum>(value);
    if (!word || !has_word(context.profile.extensions, *word))
        return set_error(context, GL_INVALID_ENUM);
    change(context, field, value);
}

void set_function(Context& context, GLenum& field, GLenum func, bool is_alpha) {
    if (is_alpha && (func == GL_DOT3_RGB || func == GL_DOT3_RGBA))
        return set_error(context, GL_INVALID_ENUM);
    set_word<CombineFunc>(context, field, func);
}

void set_alpha_operand(Context& context, GLenum& field, GLenum operand) {
    if (operand != GL_SRC_ALPHA && operand != GL_ONE_MINUS_SRC_ALPHA)
        return set_error(context, GL_INVALID_ENUM);
    change(context, field, operand);
}

void set_scale(Context& context, int& field, double scale) {
    if (scale != 1 && scale != 2 && scale != 4) return set_error(context, GL_INVALID_VALUE);
    change(context, field, int(scale));
}

/// GL_COMBINE's values. [GL13] table 3.22
void set_combine(Context& context, GLenum pname, const Params& params) {
    CombineState& rgb = context.state.texture.unit().combine_rgb;
    CombineState& alpha = context.state.texture.unit().combine_alpha;
    const GLenum value = params.token();
    switch (pname) {
        case GL_COMBINE_RGB: return set_function(context, rgb.func, value, false);
        case GL_COMBINE_ALPHA: return set_function(context, alpha.func, value, true);
        case GL_RGB_SCALE: return set_scale(context, rgb.scale, params[0]);
        case GL_ALPHA_SCALE: return set_scale(context, alpha.scale, params[0]);
    }
    const std::size_t i = pname & 3;
    if (pname >= GL_SOURCE0_RGB && pname <= GL_SOURCE2_RGB)
        return set_word<CombineSource>(context, rgb.source[i], value);
    if (pname >= GL_SOURCE0_ALPHA && pname <= GL_SOURCE2_ALPHA)
        return set_word<CombineSource>(context, alpha.source[i], value);
    if (pname >= GL_OPERAND0_RGB && pname <= GL_OPERAND2_RGB)
        return set_word<CombineOperand>(context, rgb.operand[i], value);
    if (pname >= GL_OPERAND0_ALPHA && pname <= GL_OPERAND2_ALPHA)
        return set_alpha_operand(context, alpha.operand[i], value);
    set_error(context, GL_INVALID_ENUM);
}

void set_mode(Context& context, GLenum mode) {
    const auto word = from_opengl<TexEnv>(mode);
    if (!word || !has_word(context.profile.extensions, *word))
        return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.texture.unit().env_mode, mode);
}

/// GL_ARB_point_sprite: of the unit.
void set_coord_replace(Context& context, GLenum pname, double value) {
    if (pname != GL_COORD_REPLACE || !context.profile.extensions.point_sprite)
        return set_error(context, GL_INVALID_ENUM);
    if (value != 0 && value != 1) return set_error(context, GL_INVALID_VALUE);
    change(context, context.state.point.coord_replace[context.state.texture.active], value != 0);
}

}  // namespace

namespace execute {

void tex_env(Context& context, GLenum target, GLenum pname, const Params& params) {
    TextureUnit& s = context.state.texture.unit();
    const Extensions& has = context.profile.extensions;
    if (target == GL_POINT_SPRITE) return set_coord_replace(context, pname, params[0]);
    if (target == GL_TEXTURE_FILTER_CONTROL && has.texture_lod) {
        if (pname != GL_TEXTURE_LOD_BIAS) return set_error(context, GL_INVALID_ENUM);
        return change(context, s.lod_bias, float(params[0]));
    }
    if (target != GL_TEXTURE_ENV) return set_error(context, GL_INVALID_ENUM);
    if (pname == GL_TEXTURE_ENV_MODE) return set_mode(context, params.token());
    if (pname == GL_TEXTURE_ENV_COLOR) {
        if (params.count < 4) return set_error(context, GL_INVALID_ENUM);
        return change(context, s.env_color, clamped_env_color(params));
    }
    if (!has.texture_combine) return set_error(context, GL_INVALID_ENUM);
    set_combine(context, pname, params);
}

}  // namespace execute

}  // namespace gw::gl
