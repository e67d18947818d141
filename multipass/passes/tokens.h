// The tokens that passes are written in: GL's and the paper's, one table per enumeration for
// printing and reading. Does not read TOML (pass_toml.h).
#pragma once

#include "multipass/passes/pass.h"

#include <span>
#include <string_view>
#include <utility>

namespace gw::multipass {

/// Every value of an enumeration with its token, in the order of the enumeration.
template <typename Enum>
using Token = std::pair<Enum, std::string_view>;

std::span<const Token<Parameter::Kind>> tokens(Parameter::Kind);  ///< those that are no numbers
std::span<const Token<CompareFunc>> tokens(CompareFunc);
std::span<const Token<StencilOp>> tokens(StencilOp);
std::span<const Token<BlendFactor>> tokens(BlendFactor);
std::span<const Token<BlendEquation>> tokens(BlendEquation);
std::span<const Token<Plane>> tokens(Plane);  ///< those that a pass clears
std::span<const Token<PassMap>> tokens(PassMap);
std::span<const Token<PassLights>> tokens(PassLights);
std::span<const Token<PassObjects>> tokens(PassObjects);
std::span<const Token<PassFog>> tokens(PassFog);
std::span<const Token<PassAction>> tokens(PassAction);

/// The token of a value.
template <typename Enum>
std::string_view token(Enum value) {
    for (const auto& [v, text] : tokens(value))
        if (v == value) return text;
    return "";
}

}  // namespace gw::multipass
