#include "inspect/peer/gl.h"

#include "gw/error.h"

#include <fmt/format.h>

namespace gw::peer {
namespace {

thread_local const Functions* in_use = nullptr;

}  // namespace

const Functions& gl() { return *in_use; }
void use(const Functions& functions) { in_use = &functions; }

void refuse(const char* needed, const char* feature) {
    throw Error(fmt::format("{}: needs {}; this OpenGL has version {}.{} and no such extension",
                            feature, needed, gl().version / 10, gl().version % 10));
}

GLenum token(CompareFunc func) {
    switch (func) {
        case CompareFunc::Never: return GL_NEVER;
        case CompareFunc::Less: return GL_LESS;
        case CompareFunc::Equal: return GL_EQUAL;
        case CompareFunc::LEqual: return GL_LEQUAL;
        case CompareFunc::Greater: return GL_GREATER;
        case CompareFunc::NotEqual: return GL_NOTEQUAL;
        case CompareFunc::GEqual: return GL_GEQUAL;
        case CompareFunc::Always: return GL_ALWAYS;
    }
    return GL_NONE;
}

GLenum token(StencilOp op) {
    switch (op) {
        case StencilOp::Keep: return GL_KEEP;
        case StencilOp::Zero: return GL_ZERO;
        case StencilOp::Replace: return GL_REPLACE;
        case StencilOp::Incr: return GL_INCR;
        case StencilOp::Decr: return GL_DECR;
        case StencilOp::Invert: return GL_INVERT;
        case StencilOp::IncrWrap: return GL_INCR_WRAP;
        case StencilOp::DecrWrap: return GL_DECR_WRAP;
    }
    return GL_NONE;
}

GLenum token(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero: return GL_ZERO;
        case BlendFactor::One: return GL_ONE;
        case BlendFactor::SrcColor: return GL_SRC_COLOR;
        case BlendFactor::OneMinusSrcColor: return GL_ONE_MINUS_SRC_COLOR;
        case BlendFactor::DstColor: return GL_DST_COLOR;
        case BlendFactor::OneMinusDstColor: return GL_ONE_MINUS_DST_COLOR;
        case BlendFactor::SrcAlpha: return GL_SRC_ALPHA;
        case BlendFactor::OneMinusSrcAlpha: return GL_ONE_MINUS_SRC_ALPHA;
        case BlendFactor::DstAlpha: return GL_DST_ALPHA;
        case BlendFactor::OneMinusDstAlpha: return GL_ONE_MINUS_DST_ALPHA;
        case BlendFactor::SrcAlphaSaturate: return GL_SRC_ALPHA_SATURATE;
        case BlendFactor::ConstantColor: return GL_CONSTANT_COLOR;
        case BlendFactor::OneMinusConstantColor: return GL_ONE_MINUS_CONSTANT_COLOR;
        case BlendFactor::ConstantAlpha: return GL_CONSTANT_ALPHA;
        case BlendFactor::OneMinusConstantAlpha: return GL_ONE_MINUS_CONSTANT_ALPHA;
    }
    return GL_NONE;
}

GLenum token(BlendEquation equation) {
    switch (equation) {
        case BlendEquation::Add: return GL_FUNC_ADD;
        case BlendEquation::Subtract: return GL_FUNC_SUBTRACT;
        case BlendEquation::ReverseSubtract: return GL_FUNC_REVERSE_SUBTRACT;
        case BlendEquation::Min: return GL_MIN;
        case BlendEquation::Max: return GL_MAX;
    }
    return GL_NONE;
}

GLenum token(LogicOp op) { return GL_CLEAR + GLenum(op); }

GLenum token(Face face) {
    switch (face) {
        case Face::Front: return GL_FRONT;
        case Face::Back: return GL_BACK;
        case Face::FrontAndBack: return GL_FRONT_AND_BACK;
    }
    return GL_NONE;
}

GLenum token(PolygonMode mode) {
    switch (mode) {
        case PolygonMode::Point: return GL_POINT;
        case PolygonMode::Line: return GL_LINE;
        case PolygonMode::Fill: return GL_FILL;
    }
    return GL_NONE;
}

GLenum token(FogMode mode) {
    switch (mode) {
        case FogMode::Linear: return GL_LINEAR;
        case FogMode::Exp: return GL_EXP;
        case FogMode::Exp2: return GL_EXP2;
    }
    return GL_NONE;
}

GLenum token(MinFilter filter) {
    switch (filter) {
        case MinFilter::Nearest: return GL_NEAREST;
        case MinFilter::Linear: return GL_LINEAR;
        case MinFilter::NearestMipmapNearest: return GL_NEAREST_MIPMAP_NEAREST;
        case MinFilter::LinearMipmapNearest: return GL_LINEAR_MIPMAP_NEAREST;
        case MinFilter::NearestMipmapLinear: return GL_NEAREST_MIPMAP_LINEAR;
        case MinFilter::LinearMipmapLinear: return GL_LINEAR_MIPMAP_LINEAR;
    }
    return GL_NONE;
}

GLenum token(MagFilter filter) { return filter == MagFilter::Nearest ? GL_NEAREST : GL_LINEAR; }

/// Our Clamp has no border colour: it is OpenGL 1.2's clamp to edge.
GLenum token(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat: return GL_REPEAT;
        case Wrap::Clamp: return GL_CLAMP_TO_EDGE;
        case Wrap::BorderClamp: return GL_CLAMP;
    }
    return GL_NONE;
}

GLenum token(TexEnv env) {
    switch (env) {
        case TexEnv::Modulate: return GL_MODULATE;
        case TexEnv::Decal: return GL_DECAL;
        case TexEnv::Blend: return GL_BLEND;
        case TexEnv::Replace: return GL_REPLACE;
    }
    return GL_NONE;
}

GLenum token(AccumOp op) {
    switch (op) {
        case AccumOp::Accum: return GL_ACCUM;
        case AccumOp::Load: return GL_LOAD;
        case AccumOp::Add: return GL_ADD;
        case AccumOp::Mult: return GL_MULT;
        case AccumOp::Return: return GL_RETURN;
    }
    return GL_NONE;
}

void enable(GLenum capability, bool on) { on ? gl().Enable(capability) : gl().Disable(capability); }

}  // namespace gw::peer
