// One table per enumeration, one line per value.
#include "multipass/passes/tokens.h"

#include <array>

namespace gw::multipass {
namespace {

constexpr Word<Parameter::Kind> parameter_words[] = {
    {Parameter::Kind::Object, "object"},
    {Parameter::Kind::ObjectKs, "object Ks"},
    {Parameter::Kind::ObjectTf, "object Tf"},
};
constexpr Word<CompareFunc> compare_words[] = {
    {CompareFunc::Never, "Never"},     {CompareFunc::Less, "Less"},
    {CompareFunc::Equal, "Equal"},     {CompareFunc::LEqual, "LEqual"},
    {CompareFunc::Greater, "Greater"}, {CompareFunc::NotEqual, "NotEqual"},
    {CompareFunc::GEqual, "GEqual"},   {CompareFunc::Always, "Always"},
};
constexpr Word<StencilOp> stencil_words[] = {
    {StencilOp::Keep, "Keep"},         {StencilOp::Zero, "Zero"},
    {StencilOp::Replace, "Replace"},   {StencilOp::Incr, "Incr"},
    {StencilOp::Decr, "Decr"},         {StencilOp::Invert, "Invert"},
    {StencilOp::IncrWrap, "IncrWrap"}, {StencilOp::DecrWrap, "DecrWrap"},
};
constexpr Word<BlendFactor> blend_words[] = {
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
constexpr Word<Plane> plane_words[] = {
    {Plane::Color, "color"}, {Plane::Depth, "depth"}, {Plane::Stencil, "stencil"}};
constexpr Word<PassMap> map_words[] = {
    {PassMap::None, "none"},
    {PassMap::Ambient, "ambient map"},
    {PassMap::Diffuse, "diffuse map"},
    {PassMap::Specular, "specular map"},
    {PassMap::Emission, "emission map"},
    {PassMap::Reflection, "reflection map"},
    {PassMap::Refraction, "refraction map"},
    {PassMap::Object, "object map"},
};
constexpr Word<PassLights> light_words[] = {{PassLights::None, "none"},
                                            {PassLights::Each, "each"},
                                            {PassLights::First, "first"},
                                            {PassLights::All, "all"}};
constexpr Word<PassObjects> object_words[] = {{PassObjects::All, "all"},
                                              {PassObjects::Opaque, "opaque"},
                                              {PassObjects::Translucent, "translucent"},
                                              {PassObjects::Glaring, "glaring"},
                                              {PassObjects::Casting, "casting"},
                                              {PassObjects::Named, "named"}};
constexpr Word<PassFog> fog_words[] = {
    {PassFog::None, "none"}, {PassFog::Black, "black"}, {PassFog::Scene, "scene"}};
constexpr Word<PassAction> action_words[] = {{PassAction::Draw, "draw"},
                                             {PassAction::Shadow, "shadow"},
                                             {PassAction::Add, "add"},
                                             {PassAction::Trace, "trace"}};

}  // namespace

std::span<const Word<Parameter::Kind>> words(Parameter::Kind) { return parameter_words; }
std::span<const Word<CompareFunc>> words(CompareFunc) { return compare_words; }
std::span<const Word<StencilOp>> words(StencilOp) { return stencil_words; }
std::span<const Word<BlendFactor>> words(BlendFactor) { return blend_words; }
std::span<const Word<Plane>> words(Plane) { return plane_words; }
std::span<const Word<PassMap>> words(PassMap) { return map_words; }
std::span<const Word<PassLights>> words(PassLights) { return light_words; }
std::span<const Word<PassObjects>> words(PassObjects) { return object_words; }
std::span<const Word<PassFog>> words(PassFog) { return fog_words; }
std::span<const Word<PassAction>> words(PassAction) { return action_words; }

}  // namespace gw::multipass
