#include "multipass/passes/tokens.h"

#include "gw/describe/enumerators.h"

#include <array>

namespace gw::multipass {
namespace {

/// The state's words: the enumerators themselves.
template <typename Enum>
constexpr auto state_tokens = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{Token<Enum>{static_cast<Enum>(i), names_of<Enum>[i]}...};
}
(std::make_index_sequence<count_of<Enum>>());

constexpr Token<Parameter::Kind> parameter_tokens[] = {
    {Parameter::Kind::Object, "object"},
    {Parameter::Kind::ObjectKs, "object Ks"},
    {Parameter::Kind::ObjectTf, "object Tf"},
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

template <typename Enum, std::size_t size>
constexpr bool has_all(const Token<Enum> (&)[size]) {
    return size == count_of<Enum>;
}
static_assert(has_all(map_tokens) && has_all(light_tokens) && has_all(object_tokens) &&
              has_all(fog_tokens) && has_all(action_tokens));

}  // namespace

std::span<const Token<Parameter::Kind>> tokens(Parameter::Kind) { return parameter_tokens; }
std::span<const Token<CompareFunc>> tokens(CompareFunc) { return state_tokens<CompareFunc>; }
std::span<const Token<StencilOp>> tokens(StencilOp) { return state_tokens<StencilOp>; }
std::span<const Token<BlendFactor>> tokens(BlendFactor) { return state_tokens<BlendFactor>; }
std::span<const Token<BlendEquation>> tokens(BlendEquation) { return state_tokens<BlendEquation>; }
std::span<const Token<Plane>> tokens(Plane) { return plane_tokens; }
std::span<const Token<PassMap>> tokens(PassMap) { return map_tokens; }
std::span<const Token<PassLights>> tokens(PassLights) { return light_tokens; }
std::span<const Token<PassObjects>> tokens(PassObjects) { return object_tokens; }
std::span<const Token<PassFog>> tokens(PassFog) { return fog_tokens; }
std::span<const Token<PassAction>> tokens(PassAction) { return action_tokens; }

}  // namespace gw::multipass
