// Command lists: the only input of a machine. A list is a value, which can be built, printed,
// stored, replayed and compared. Does not execute anything and has no pixels of a machine.
#pragma once

#include "gw/base/shared_value.h"
#include "gw/material.h"
#include "gw/mesh.h"
#include "gw/planes.h"
#include "gw/state.h"
#include "gw/texture.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gw {

/// Opens a pass. The commands up to the next BeginPass are counted under its name.
struct BeginPass {
    std::string name;
    PlaneMask digests = 0;  ///< the planes whose digests are taken when the pass ends
    bool operator==(const BeginPass&) const = default;
};

/// Clears planes inside the scissor box, through the colour mask, depth mask and stencil write
/// mask, as glClear.
struct Clear {
    PlaneMask planes = 0;
    vec4 color{0, 0, 0, 0};  ///< clamped to [0,1], times 2^color_bits - 1, to nearest
    double depth = 1;        ///< clamped to [0,1], times 2^depth_bits - 1, to nearest
    int stencil = 0;         ///< low stencil_bits are used
    vec4 accum{0, 0, 0, 0};  ///< clamped to [-1,1], times 2^color_bits - 1, to nearest
    bool operator==(const Clear&) const = default;
};

/// Replaces the whole state for the following commands; it persists over lists.
struct SetState {
    SharedValue<State> state;
    bool operator==(const SetState&) const = default;
};

/// A plane of a surface.
struct SurfacePlane {
    std::uint32_t surface = 1;
    Plane plane = Plane::Color;  ///< Color or Depth
    bool operator==(const SurfacePlane&) const = default;
};

/// The texture of a draw: a value, a texture slot that CopyTexture filled, or a plane of a surface
/// that is not drawn to. Texturing is off if none is given.
struct TextureBinding {
    TextureRef texture;
    std::optional<std::uint32_t> slot;
    std::optional<SurfacePlane> surface{};  ///< extension surfaces: its texels as they are now
    bool enabled() const { return texture != nullptr || slot.has_value() || surface.has_value(); }
    bool operator==(const TextureBinding&) const = default;
};

/// Of texture units 1 to 3.
using MoreBindings = std::array<TextureBinding, max_texture_units - 1>;
using MoreTexcoords = std::array<vec4, max_texture_units - 1>;
inline constexpr MoreTexcoords initial_texcoords{vec4(0, 0, 0, 1), vec4(0, 0, 0, 1),
                                                 vec4(0, 0, 0, 1)};

/// The values of all vertices for which the mesh has none.
struct CurrentValues {
    vec4 color{1, 1, 1, 1};
    vec3 normal{0, 0, 1};
    vec4 texcoord{0, 0, 0, 1};  ///< s, t, r, q
    vec3 secondary_color{0, 0, 0};
    float fog_coordinate = 0;
    MoreTexcoords more_texcoords = initial_texcoords;
    bool operator==(const CurrentValues&) const = default;
};

/// Draws a mesh with the current state.
struct Draw {
    MeshRef mesh;
    /// any matrix; normals are transformed by the inverse transpose of its upper 3x3
    dmat4 eye_from_object{1};
    Material material;  ///< of both sides, unless `back_material` is given
    std::shared_ptr<const Material> back_material;  ///< used with lighting.two_side
    std::shared_ptr<const CurrentValues> current;   ///< null: their initial values
    LightsRef lights;
    TextureBinding map;
    std::shared_ptr<const MoreBindings> more_maps;  ///< null: they are off
    /// ColorSource::PolygonId: the id is (id_base + mesh polygon id mod 2^32) >> id_shift.
    std::uint32_t id_base = 0;
    int id_shift = 0;  ///< 0 .. 31
    bool operator==(const Draw&) const = default;
};

/// The texture of a unit of a Draw or DrawPixels.
const TextureBinding& map_of(const auto& command, std::size_t unit) {
    static const TextureBinding off;
    if (unit == 0) return command.map;
    return command.more_maps ? (*command.more_maps)[unit - 1] : off;
}
/// Whether a unit has a texture.
bool is_textured(const auto& command) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (map_of(command, unit).enabled()) return true;
    return false;
}

/// A run of pixels in one row, in window coordinates.
struct Span {
    int x = 0, y = 0, length = 0;  ///< x, y -4096 .. 4096
    std::uint32_t first = 0;       ///< index of its first colour
    /// all pixels have colour `first`; else pixel i has colour `first + i`
    bool flat = true;
    bool operator==(const Span&) const = default;
};
/// Makes a fragment of each pixel of the spans. Fragments go through scissor, alpha, stencil and
/// depth tests, blending and masks.
struct WriteSpans {
    std::vector<Span> spans;
    std::vector<Rgba> colors;  ///< each channel <= 2^color_bits - 1
    std::uint32_t depth = 0;   ///< of every fragment, in units of the depth plane
    bool operator==(const WriteSpans&) const = default;
};

/// Writes a rectangle of pixels from the host, bottom row first. Colours make fragments of depth
/// `depth`, which go through all tests, blending and masks. Depth and stencil values are written
/// through scissor and masks only.
struct WritePixels {
    Rect rect;
    Plane plane = Plane::Color;         ///< Color, Depth or Stencil
    std::vector<Rgba> colors;           ///< Plane::Color: rect.area() colours
    std::vector<std::uint32_t> values;  ///< Depth, Stencil: rect.area() values
    std::uint32_t depth = 0;
    bool operator==(const WritePixels&) const = default;
};

/// An operation on the accumulation buffer inside the scissor box, in glAccum's words.
enum class AccumOp : std::uint8_t { Accum, Load, Add, Mult, Return };
struct Accumulate {
    AccumOp op = AccumOp::Accum;
    float value = 1;
    bool operator==(const Accumulate&) const = default;
};

/// Copies a rectangle of one plane to another position in the same plane (glCopyPixels), through
/// scissor and masks. Colours go from the read buffer to the draw buffer. Source pixels outside the window are skipped. Overlapping rectangles copy as
/// if the whole source were read first.
struct Copy {
    Plane plane = Plane::Color;  ///< Color, Depth or Stencil
    Rect source;
    int x = 0, y = 0;  ///< lower left corner of the destination
    bool operator==(const Copy&) const = default;
};

/// The values that all fragments of a DrawPixels share (glRasterPos).
struct RasterPosition {
    double x = 0, y = 0;  ///< window coordinates of the rectangle's corner
    std::uint32_t depth = 0;
    Rgba color{};               ///< each channel <= 2^color_bits - 1
    vec4 texcoord{0, 0, 0, 1};  ///< s, t, r, q after the texture matrix
    double distance = 0;        ///< from the eye, for fog: >= 0
    Rgba secondary_color{};     ///< each channel <= 2^color_bits - 1; the last is unused
    double fog_coordinate = 0;  ///< in place of the distance, for FogSource::Coordinate
    MoreTexcoords more_texcoords = initial_texcoords;
    bool operator==(const RasterPosition&) const = default;
};

/// The rectangle of the window whose pixels a DrawPixels draws again (glCopyPixels).
struct PixelSource {
    Plane plane = Plane::Color;  ///< Color, Depth or Stencil
    int x = 0, y = 0;            ///< its lower left corner
    bool operator==(const PixelSource&) const = default;
};

/// Extension draw_pixels: makes fragments of a rectangle of pixels, zoomed, bottom row first
/// (glDrawPixels, glBitmap, glCopyPixels). They go through texture, fog, all tests, blending and
/// masks. What the pixels do not give, the raster position does. Stencil values make no fragments;
/// they are written through scissor and mask.
struct DrawPixels {
    int width = 0, height = 0;  ///< of the rectangle, before the zoom
    RasterPosition raster;
    double zoom_x = 1, zoom_y = 1;        ///< of any sign
    std::vector<Rgba> colors;             ///< width * height, or none
    std::vector<std::uint32_t> depths;    ///< width * height, or none
    std::vector<std::uint32_t> stencils;  ///< width * height, or none; then no colours or depths
    /// Only pixels whose bit is set are drawn. A row begins with a new byte, its first pixel is the
    /// byte's highest bit. None: all are.
    std::vector<std::uint8_t> bits;
    std::optional<PixelSource> source;  ///< gives colours, depths or stencil values
    TextureBinding map;
    std::shared_ptr<const MoreBindings> more_maps;  ///< null: they are off

    std::size_t area() const { return Rect{0, 0, width, height}.area(); }
    std::size_t bit_row() const { return (std::size_t(width) + 7) / 8; }  ///< bytes of a row
    bool operator==(const DrawPixels&) const = default;
};

/// Fills a texture slot from a rectangle of the colour or depth plane (glCopyTexImage2D). The
/// rectangle lies inside the window; without texture_sizes its sides are powers of two. A depth slot is a texture for
/// shadow_compare, or is read as grey.
struct CopyTexture {
    std::uint32_t slot = 0;  ///< 0 .. 255
    Plane plane = Plane::Color;
    Rect rect;
    bool operator==(const CopyTexture&) const = default;
};

/// Reads a rectangle of a plane back (glReadPixels). Machine::readbacks() has the result under
/// `key`, unless Machine::read_into gave other memory for it.
struct Read {
    std::uint32_t key = 0;
    Plane plane = Plane::Color;
    Rect rect;
    bool packed = false;  ///< colours of at most 8 bits as 32-bit words, R lowest (lrectread)
    bool operator==(const Read&) const = default;
};

/// Exchanges the front and the back plane.
struct SwapBuffers {
    bool operator==(const SwapBuffers&) const = default;
};

/// Extension occlusion_query: begins or ends the count of fragments that pass all tests
/// (glBeginQuery, GL_SAMPLES_PASSED). One query is active at a time, over lists too.
struct Query {
    std::uint32_t key = 0;
    bool begin = true;
    bool operator==(const Query&) const = default;
};

/// Extension surfaces: makes a surface, all of whose values are 0, in place of the one that has
/// the number. Sides of 0: there is none any more.
struct MakeSurface {
    std::uint32_t number = 1;  ///< 1 .. max_surfaces
    Surface surface;
    bool operator==(const MakeSurface&) const = default;
};

/// Extension surfaces: the following commands draw to this surface and read from it. 0: the window.
struct UseSurface {
    std::uint32_t number = 0;
    bool operator==(const UseSurface&) const = default;
};

/// Extension surfaces: copies a rectangle of another surface, or of this one, to the surface in use
/// (glBlitFramebuffer). It is scaled to the target's size. The scissor box cuts it; no mask does.
struct Blit {
    std::uint32_t from_surface = 0;  ///< the source's number; 0: the window
    PlaneMask planes = 0;  ///< of Color, Depth and Stencil: those that both have are copied
    Rect source, target;   ///< corners within -8192 .. 8192, sides 0 .. 8192
    bool flip_x = false, flip_y = false;
    MagFilter filter = MagFilter::Nearest;  ///< of colours; depths and stencil values are Nearest
    bool operator==(const Blit&) const = default;
};

using Command =
    std::variant<BeginPass, Clear, SetState, Draw, WriteSpans, WritePixels, Accumulate, Copy,
                 CopyTexture, Read, DrawPixels, SwapBuffers, Query, MakeSurface, UseSurface, Blit>;

/// Commands in order. Meshes, textures and lights are immutable and shared between lists; == of
/// commands compares their addresses, inspect/compare/difference.h their content.
struct CommandList {
    std::vector<Command> commands;

    void add(Command command) { commands.push_back(std::move(command)); }
    void append(const CommandList& other) {
        commands.insert(commands.end(), other.commands.begin(), other.commands.end());
    }
};

}  // namespace gw
