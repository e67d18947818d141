// A pass as the paper writes one [K3p]: a set of parameters for the machine, (Ka, Kd, Ks, Ke, Map).
// Its tests and blending go with it. Plain data. Does not choose the passes of a picture
// (catalogue.h) and does not draw.
#pragma once

#include "gw/command_list.h"
#include "gw/state.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gw::multipass {

/// A pass's name, at most 31 bytes, kept inside the value so that passes can be constants.
struct Name {
    static constexpr std::size_t most = 31;
    std::array<char, most + 1> text{};

    constexpr Name() = default;
    constexpr Name(std::string_view name) {
        for (std::size_t i = 0; i < name.size() && i + 1 < text.size(); ++i) text[i] = name[i];
    }
    constexpr Name(const char* name) : Name(std::string_view(name)) {}
    constexpr std::string_view view() const { return text.data(); }
    std::string str() const { return text.data(); }
    bool operator==(const Name&) const = default;
};

/// A pass's value for one parameter of the material: the object's own value, 0, 1, or any other.
struct Parameter {
    enum class Kind : std::uint8_t { Value, Object, ObjectKs, ObjectTf };
    Kind kind = Kind::Value;
    std::array<float, 3> value{};

    constexpr Parameter(double v = 0) : value{float(v), float(v), float(v)} {}
    constexpr Parameter(float r, float g, float b) : value{r, g, b} {}
    constexpr explicit Parameter(Kind k) : kind(k) {}
    bool operator==(const Parameter&) const = default;
};
/// The object's own value of the parameter that it is written for.
inline constexpr Parameter object{Parameter::Kind::Object};
/// The object's Ks and Tf, for Ke: the strengths of reflection and refraction maps [K3 eq. 2].
inline constexpr Parameter object_Ks{Parameter::Kind::ObjectKs};
inline constexpr Parameter object_Tf{Parameter::Kind::ObjectTf};

/// Which of the object's maps modulates the pass. Several maps: the pass is repeated for each
/// [K3.1].
enum class PassMap : std::uint8_t {
    None,
    Ambient,
    Diffuse,
    Specular,
    Emission,
    Reflection,
    Refraction,
    Object
};
inline constexpr PassMap no_map = PassMap::None;
inline constexpr PassMap ambient_map = PassMap::Ambient;
inline constexpr PassMap diffuse_map = PassMap::Diffuse;
inline constexpr PassMap specular_map = PassMap::Specular;
inline constexpr PassMap emission_map = PassMap::Emission;
/// sphere map; objects without one are not drawn
inline constexpr PassMap reflection_map = PassMap::Reflection;
/// the same, by the refracted ray
inline constexpr PassMap refraction_map = PassMap::Refraction;
/// the object's one map of eq. 1 [K2]
inline constexpr PassMap object_map = PassMap::Object;

/// The parameter set, in the paper's order.
struct PassMaterial {
    Parameter Ka, Kd, Ks, Ke;
    PassMap Map = no_map;
    bool operator==(const PassMaterial&) const = default;
};

/// How often a pass runs, and by which light. Each: once per light; neighbouring passes are
/// repeated together. First: once, by the first light that casts a shadow, if there is one.
enum class PassLights : std::uint8_t { None, Each, First, All };
/// The objects that take part. Opaque: d = 1. Glaring: emitters with glare, moved [K3.3]. Casting:
/// opaque ones that cast shadows.
enum class PassObjects : std::uint8_t { All, Opaque, Translucent, Glaring, Casting, Named };
/// The fog that a pass goes through [K3.5].
enum class PassFog : std::uint8_t { None, Black, Scene };
/// The work of a pass.
///   Draw    draws the objects
///   Shadow  sets the stencil: not 0 in the light's shadow, 0 elsewhere [K3.2]
///   Add     adds the frame buffer to the accumulation buffer, whose sum is the picture, and clears
///           the colour to black
///   Trace   writes the traced component, a pixel rectangle from the host (eq. 5) [K4]
enum class PassAction : std::uint8_t { Draw, Shadow, Add, Trace };

struct Pass {
    Name name;
    PassAction action = PassAction::Draw;
    PlaneMask clear = 0;  ///< before: colour to the background, Z to the farthest, stencil to 0
    PassMaterial material;
    DepthState depth;
    StencilState stencil;
    BlendState blend;
    bool color = true;  ///< false: the frame buffer keeps its colours
    PassFog fog = PassFog::None;
    PassLights lights = PassLights::None;
    PassObjects objects = PassObjects::All;
    std::vector<std::string> names{};  ///< PassObjects::Named
    bool operator==(const Pass&) const = default;
};

/// The passes of a picture, in order.
using PassList = std::vector<Pass>;

/// Whether the pass adds to the visible surfaces: under Equal, blended, stencil kept. Coincident
/// faces would add twice in it (one_winner.h).
bool is_additive(const Pass& pass);

/// Whether the pass draws translucent objects layer by layer (translucency.h): under Equal.
bool is_layer_pass(const Pass& pass);

/// "(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map)", as the paper writes it.
std::string to_string(const PassMaterial& material);
/// One line: name, set, lights, objects, and the fields of depth, stencil, blend and fog that are
/// not at their initial values.
std::string to_string(const Pass& pass);

}  // namespace gw::multipass
