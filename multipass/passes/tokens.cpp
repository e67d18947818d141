#include "multipass/passes/tokens.h"

#include <array>

namespace gw::multipass {
namespace {

constexpr Token<Parameter::Kind> parameter_tokens[] = {
    {Parameter::Kind::Object, "object"},
    {Parameter::Kind::ObjectKs, "object Ks"},
    {Parameter::Kind::ObjectTf, "object Tf"},
};
constexpr Token<CompareFunc> compare_tokens[] = {
    {CompareFunc::Never, "Never"},     {CompareFunc::Less, "Less"},
    {CompareFunc::Equal, "Equal"},     {CompareFunc::LEqual, "LEqual"},
    {CompareFunc::Greater, "Greater"}, {CompareFunc::NotEqual, "NotEqual"},
    {CompareFunc::GEqual, "GEqual"},   {CompareFunc::Always, "Always"},
};
constexpr Token<StencilOp> stencil_tokens[] = {
    {StencilOp::Keep, "Keep"},         {StencilOp::Zero, "Zero"},
    {StencilOp::Replace, "Replace"},   {StencilOp::Incr, "Incr"},
    {StencilOp::Decr, "Decr"},         {StencilOp::Invert, "Invert"},
    {StencilOp::IncrWrap, "IncrWrap"}, {StencilOp::DecrWrap, "DecrWrap"},
};
constexpr Token<BlendFactor> blend_tokens[] = {
    {BlendFactor::Zero, "Zero"},
    {BlendFactor::One, "One"},
    {BlendFactor::SrcColor, "SrcColor"},
    {BlendFactor::OneMinusSrcColor, "OneMinusSrcColor"},
    {BlendFactor::DstColor, "DstColor"},
    {BlendFactor::OneMinusDstColor, "OneMinusDstColor"},
    {BlendFactor::SrcAlpha, "SrcAlpha"},
    {BlendFactor::OneMinusSrcAlpha, "OneMinusSrcAlpha"},
    {BlendFactor::DstAlpha, "DstAlpha"},
    {BlendFactor::OneMinusDstAlpha, "OneMinusDstAlpha"},
    {BlendFactor::SrcAlphaSaturate, "SrcAlphaSaturate"},
};
constexpr Token<Plane> plane_tokens[] = {
    {Plane::Color, "color"}, {Plane::Depth, "depth"}, {Plane::Stencil, "stencil"}};
constexpr Token<PassMap> map_tokens[] = {
    {PassMap::None, "none"},
    {PassMap::Ambient, "ambient map"},
    {PassMap::Diffuse, "diffuse map"},
    {PassMap::Specular, "specular map"},
    {PassMap::Emission, "emission map"},
    {PassMap::Reflection, "reflection map"},
    {PassMap::Refraction, "refraction map"},
    {PassMap::Object, "object map"},
};
constexpr Token<PassLights> light_tokens[] = {{PassLights::None, "none"},
                                              {PassLights::Each, "each"},
                                              {PassLights::First, "first"},
                                              {PassLights::All, "all"}};
constexpr Token<PassObjects> object_tokens[] = {{PassObjects::All, "all"},
                                                {PassObjects::Opaque, "opaque"},
                                                {PassObjects::Translucent, "translucent"},
                                                {PassObjects::Glaring, "glaring"},
                                                {PassObjects::Casting, "casting"},
                                                {PassObjects::Named, "named"}};
constexpr Token<PassFog> fog_tokens[] = {
    {PassFog::None, "none"}, {PassFog::Black, "black"}, {PassFog::Scene, "scene"}};
constexpr Token<PassAction> action_tokens[] = {{PassAction::Draw, "draw"},
                                               {PassAction::Shadow, "shadow"},
                                               {PassAction::Add, "add"},
                                               {PassAction::Trace, "trace"}};

}  // namespace

std::span<const Token<Parameter::Kind>> tokens(Parameter::Kind) { return parameter_tokens; }
std::span<const Token<CompareFunc>> tokens(CompareFunc) { return compare_tokens; }
std::span<const Token<StencilOp>> tokens(StencilOp) { return stencil_tokens; }
std::span<const Token<BlendFactor>> tokens(BlendFactor) { return blend_tokens; }
std::span<const Token<Plane>> tokens(Plane) { return plane_tokens; }
std::span<const Token<PassMap>> tokens(PassMap) { return map_tokens; }
std::span<const Token<PassLights>> tokens(PassLights) { return light_tokens; }
std::span<const Token<PassObjects>> tokens(PassObjects) { return object_tokens; }
std::span<const Token<PassFog>> tokens(PassFog) { return fog_tokens; }
std::span<const Token<PassAction>> tokens(PassAction) { return action_tokens; }

}  // namespace gw::multipass
