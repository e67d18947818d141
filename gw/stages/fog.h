// Fog: its factor at a vertex, and the table that gives it per fragment. docs/manual.md, "Fog".
// Does not blend: tables.h does.
#pragma once

#include "gw/profile.h"
#include "gw/state.h"

#include <cstdint>
#include <vector>

namespace gw {

/// Whether the factor is found per fragment: what the state says, or the profile's default [K] Fig.
/// 2.
bool fog_is_per_fragment(const FogState& fog, const Profile& profile);

/// 1 at no fog .. 0, as an n-bit fraction, at eye distance z >= 0.
std::uint32_t fog_factor(const FogState& fog, double z, int bits);

/// Steps of the fragment table as a power of two: 256, or 1024 above 8 bits.
constexpr int fog_table_log2(int bits) { return bits == 8 ? 8 : 10; }

/// The eye distance of the table's last entry; beyond it the factor stays.
double fog_table_depth(const FogState& fog, int bits);

/// Factors at i * fog_table_depth / steps, i = 0 .. steps.
std::vector<std::uint32_t> fog_table(const FogState& fog, int bits);

}  // namespace gw
