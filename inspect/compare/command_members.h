// The members of commands and of what they refer to, by name: what is compared when two of a kind
// differ.
// A Draw's mesh, lights and map are not here: they are shared values with members of their own.
#pragma once

#include "gw/command_list.h"

#include <tuple>

namespace gw::inspect {

template <typename Struct, typename Value>
struct NamedMember {
    const char* name;
    Value Struct::*member;
};
template <typename Struct, typename Value>
constexpr NamedMember<Struct, Value> named(const char* name, Value Struct::*member) {
    return {name, member};
}

/// A std::tuple of NamedMember, in the order in which they are compared.
template <typename Struct>
inline constexpr auto members_of = std::tuple<>();

template <>
inline constexpr auto members_of<MeshData> = std::tuple(
    named("primitive", &MeshData::primitive), named("positions", &MeshData::positions),
    named("indices", &MeshData::indices), named("polygon_sizes", &MeshData::polygon_sizes),
    named("normals", &MeshData::normals), named("texcoords", &MeshData::texcoords),
    named("colors", &MeshData::colors), named("polygon_ids", &MeshData::polygon_ids));

template <>
inline constexpr auto members_of<TextureLevel> = std::tuple(
    named("map's width", &TextureLevel::width), named("map's height", &TextureLevel::height),
    named("map's values", &TextureLevel::rgba));

template <>
inline constexpr auto members_of<Light> =
    std::tuple(named("light.position", &Light::position), named("light.Ia", &Light::Ia),
               named("light.Id", &Light::Id), named("light.Is", &Light::Is),
               named("light.spot_direction", &Light::spot_direction),
               named("light.spot_exponent", &Light::spot_exponent),
               named("light.spot_cos_cutoff", &Light::spot_cos_cutoff),
               named("light.constant_attenuation", &Light::constant_attenuation),
               named("light.linear_attenuation", &Light::linear_attenuation),
               named("light.quadratic_attenuation", &Light::quadratic_attenuation));

template <>
inline constexpr auto members_of<Material> = std::tuple(
    named("Ka", &Material::Ka), named("Kd", &Material::Kd), named("Ks", &Material::Ks),
    named("Ke", &Material::Ke), named("Ns", &Material::Ns), named("alpha", &Material::alpha));

template <>
inline constexpr auto members_of<Draw> = std::tuple(named("eye_from_object",
                                                          &Draw::eye_from_object),
                                                    named("id_base", &Draw::id_base),
                                                    named("id_shift", &Draw::id_shift));

template <>
inline constexpr auto members_of<BeginPass> = std::tuple(named("name", &BeginPass::name));

template <>
inline constexpr auto members_of<Clear> = std::tuple(named("planes", &Clear::planes),
                                                     named("color", &Clear::color),
                                                     named("depth", &Clear::depth),
                                                     named("stencil", &Clear::stencil));

template <>
inline constexpr auto members_of<WriteSpans> = std::tuple(named("spans", &WriteSpans::spans),
                                                          named("colors", &WriteSpans::colors),
                                                          named("depth", &WriteSpans::depth));

template <>
inline constexpr auto members_of<WritePixels> = std::tuple(named("plane", &WritePixels::plane),
                                                           named("rect", &WritePixels::rect),
                                                           named("colors", &WritePixels::colors),
                                                           named("values", &WritePixels::values),
                                                           named("depth", &WritePixels::depth));

template <>
inline constexpr auto members_of<Accumulate> = std::tuple(named("op", &Accumulate::op),
                                                          named("value", &Accumulate::value));

template <>
inline constexpr auto members_of<Copy> = std::tuple(named("plane", &Copy::plane),
                                                    named("source", &Copy::source),
                                                    named("x", &Copy::x), named("y", &Copy::y));

template <>
inline constexpr auto members_of<CopyTexture> = std::tuple(named("slot", &CopyTexture::slot),
                                                           named("plane", &CopyTexture::plane),
                                                           named("rect", &CopyTexture::rect));

template <>
inline constexpr auto members_of<Read> = std::tuple(named("key", &Read::key),
                                                    named("plane", &Read::plane),
                                                    named("rect", &Read::rect),
                                                    named("packed", &Read::packed));

}  // namespace gw::inspect
