// The words that passes are written in: GL's tokens and the paper's, one table for printing and
// reading.
// Does not read TOML (pass_toml.h does).
#pragma once

#include "multipass/passes/pass.h"

#include <span>
#include <string_view>
#include <utility>

namespace gw::multipass {

/// Every value of an enumeration with its word, in the order of the enumeration.
template <typename Enum>
using Word = std::pair<Enum, std::string_view>;

std::span<const Word<Parameter::Kind>> words(Parameter::Kind);  ///< those that are no numbers
std::span<const Word<CompareFunc>> words(CompareFunc);
std::span<const Word<StencilOp>> words(StencilOp);
std::span<const Word<BlendFactor>> words(BlendFactor);
std::span<const Word<Plane>> words(Plane);  ///< those that a pass clears
std::span<const Word<PassMap>> words(PassMap);
std::span<const Word<PassLights>> words(PassLights);
std::span<const Word<PassObjects>> words(PassObjects);
std::span<const Word<PassFog>> words(PassFog);
std::span<const Word<PassAction>> words(PassAction);

/// The word of a value.
template <typename Enum>
std::string_view word(Enum value) {
    for (const auto& [v, text] : words(value))
        if (v == value) return text;
    return "";
}

}  // namespace gw::multipass
