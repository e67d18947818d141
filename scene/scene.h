// A scene as plain data: objects, materials, lights, camera, fog. World space: right-handed, any
// unit, y up. Knows texture files by name and line only (image::load_textures reads the texels).
// Does not draw.
#pragma once

#include "gw/base/types.h"
#include "gw/mesh.h"
#include "gw/state.h"
#include "gw/texture.h"
#include "scene/photometry.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gw::scene {

/// The place in a file that asks for something, for errors.
struct Origin {
    std::string file;
    int line = 0;
};

/// What a map of opacity takes of a texel: MTL's -imfchan.
enum class OpacityChannel {
    Alpha,
    AlphaOrLuminance,  ///< alpha if the texture has texels of alpha below 1, else luminance
    Luminance,
    Red,
    Green,
    Blue,
};

struct PatchedLookup;

/// A map: its file, the place that names it, how it is looked up, and (after image::load_textures)
/// its texels.
struct Map {
    /// absolute or relative to the working directory; separators are '/'
    std::filesystem::path file;
    /// the picture file itself, if it lies within another file; `file` is then a name for messages
    std::shared_ptr<const std::string> bytes;
    Origin origin;
    std::string place{};  ///< the part of that file that names it; empty: the map's own statement
    Wrap wrap_s = Wrap::Repeat, wrap_t = Wrap::Repeat;  ///< MTL -clamp on: Clamp
    vec2 offset{0, 0};                                  ///< MTL -o: added to s, t after scale
    vec2 scale{1, 1};                                   ///< MTL -s
    /// above 0: no file, but generated from the scene with this many texels a side [K3.1]
    int from_scene = 0;
    /// A model names it: if its file is missing, the model is drawn without it.
    bool may_lack = false;
    TextureRef texture;  ///< null until loaded, or generated (multipass/frame/scene_maps.h)
    OpacityChannel channel = OpacityChannel::Alpha;  ///< of map_d
    /// The mean of its texels stands for it: its coordinates are of a set that the mesh lacks.
    bool is_mean = false;
    /// It lies on its mesh in another way than by the mesh's coordinates: maps/finish.h makes a texture
    /// of these patches.
    std::shared_ptr<const PatchedLookup> patched;
};

struct Physical;

/// MTL's material in MTL's words [K2, K3]. A component may have several maps: its pass is repeated
/// for each [K3.1].
struct Material {
    std::string name;
    vec3 Ka{0.2f, 0.2f, 0.2f}, Kd{0.8f, 0.8f, 0.8f}, Ks{0, 0, 0}, Ke{0, 0, 0};
    float Ns = 0;
    float Ni = 1;  ///< index of refraction
    float d = 1;   ///< opacity (1 - Tr)
    /// Opacity that varies [GLTF2 3.9.4]: d times that of a map, if there is one, and with vertex_d
    /// the alpha of the mesh's colours. maps/finish.h cuts objects by it. What draws a scene finds
    /// none.
    std::vector<Map> map_d;
    bool vertex_d = false;
    std::optional<float> d_cutoff;  ///< the product without d is 1 from here on, else 0
    vec3 Tf{1, 1, 1};               ///< transmission filter
    int illum = 2;                  ///< 3 and up: ray-traced reflection
    /// Kd and its maps are reflectances encoded as in sRGB, for a display [GLTF2]: radiosity decodes them
    bool is_encoded = false;
    std::vector<Map> map_Ka, map_Kd, map_Ks, map_Ke;
    std::vector<Map> refl;        ///< sphere maps for the reflection component
    std::vector<Map> refraction;  ///< sphere maps looked up by the refracted ray [K1]
    /// At most one. G of its texels multiplies the surface's roughness, B its metallic part
    /// [GLTF2 3.9.2]; or RGB its F0, if that is given, and A its glossiness. maps/finish.h makes Ka, Kd,
    /// Ks, Ns and their maps of it.
    std::vector<Map> map_metal;
    std::shared_ptr<const Physical> physical;  ///< glTF's surface; null: it is no such
};

/// Light around a self-luminous object: its picture, superposed at places over a range in the
/// picture's plane [K3.3].
struct Glare {
    double radius = 0.5;    ///< of the range, world units
    float strength = 0.5f;  ///< of the superposed emission, relative to the object's own
    int rays = 0;           ///< 0: the range is a disc; else a star of this many rays
    int samples = 32;       ///< superposed pictures, at least
};

/// The pixmap that holds an object's radiosity [F2.1]. By default planar parts get a pixmap each by
/// projection, curved ones a pixmap for each chart.
struct PixmapChoice {
    /// objects of one name share a pixmap; empty: the object's own
    std::string name;
    int width = 0, height = 0;     ///< texels; 0: by texels_per_unit
    double texels_per_unit = 0;    ///< 0: the scene's
    bool given_st = false;         ///< ST are the mesh's texcoords; else they are generated
    std::optional<vec3> emission;  ///< instead of the material's Ke
    double lumen = 0;              ///< above 0: of the whole object, instead of both
    vec3 color{1, 1, 1};           ///< of these lumens
    Origin origin;
};

/// One mesh with one material, placed in the world. Several may share a name (a group with several
/// materials).
struct Object {
    std::string name;  ///< its name in `only = [...]` and per-object overrides
    MeshRef mesh;
    std::size_t material = 0;    ///< index into Scene::materials
    dmat4 world_from_object{1};  ///< in the middle of the exposure
    dvec3 move{0};               ///< how far it moves while the shutter is open, world units [K1]
    std::optional<Glare> glare;  ///< of an object that emits
    bool casts_shadow = true;    ///< false: light goes through it, as through translucent ones
    /// Whether faces that turn their clockwise side to the eye are not drawn. They cast shadows.
    bool single_sided = false;
    PixmapChoice pixmap;  ///< [F2.1]
};

enum class LightKind { Directional, Point, Spot };
enum class Shadow { None, Volume, Map };

/// The shape a light's positions (or an emitter's displacements) range over, for soft shadows and
/// glare [K3.3].
struct AreaLight {
    enum class Shape { None, Disc, Rectangle, Line } shape = Shape::None;
    vec3 u{0, 0, 0}, v{0, 0, 0};  ///< half axes in world units (Line uses u only)
    int samples = 16;
};

struct Light {
    std::string name;
    LightKind kind = LightKind::Directional;
    vec3 position{0, 0, 0};    ///< Point, Spot
    vec3 direction{0, -1, 0};  ///< Directional, Spot: the direction in which the light travels
    vec3 Ia{0, 0, 0}, Id{1, 1, 1};
    std::optional<vec3> Is;  ///< absent: Id (the reading of [K] eq. 1 and 3)
    double cone_angle = 45;  ///< Spot: half angle, degrees
    float spot_exponent = 0;
    float constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0;
    Shadow shadow = Shadow::None;
    AreaLight area;
    std::set<std::string> only;  ///< names of the objects it lights; empty: all [K3.3]
    /// its intensity in candela, for radiosity; Id and attenuation show it in passes
    std::optional<Luminous> luminous;
};

struct Camera {
    dvec3 eye{0, 0, 5}, at{0, 0, 0}, up{0, 1, 0};
    double fov = 40;                       ///< vertical, degrees
    double near_plane = 0, far_plane = 0;  ///< distances; 0: fitted to the scene
    double ortho_height = 0;               ///< > 0: orthographic, this many world units high
    /// radius of the lens, world units; 0: everything is sharp [K1]
    double aperture = 0;
    double focus = 0;  ///< distance that is sharp; 0: that of `at`
};

struct Fog {
    FogMode mode = FogMode::Linear;
    vec3 color{0.5f, 0.5f, 0.5f};
    float density = 1, start = 0, end = 1;
};

struct Scene {
    std::string name;
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::optional<Camera> camera;  ///< absent: fit_camera
    std::optional<Fog> fog;
    vec3 background{0, 0, 0};
    /// the illuminance, in lux, under which a white surface is white in pictures; 0: light has no unit
    double white = 0;
    /// of pixmaps without their own; 0: fitted to the scene [F2.1]
    double texels_per_unit = 0;
    bool reflection_in_shadow = true;  ///< reflection maps are drawn in shadow too [K3.2]
};

/// Axis-aligned bounds in world space, if nothing else is said; `empty` if there is no vertex.
struct Bounds {
    dvec3 low{0}, high{0};
    bool empty = true;
};
Bounds bounds(const Scene& scene);
/// The box, and p.
void extend(Bounds& box, const dvec3& p);
/// Corner i = 0 .. 7 of a box: bits 0, 1, 2 choose the higher x, y, z.
inline dvec3 corner(const Bounds& b, int i) {
    return {i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z};
}

}  // namespace gw::scene
