// One primitive's planes in a tile, for one draw, and batches of such planes. docs/manual.md,
// "Planes", "Perspective". Does not evaluate planes over blocks: the kernels do.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/frame/tile_plane.h"
#include "gw/fast/raster/setup.h"
#include "gw/stages/perspective.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <vector>

namespace gw::fast {

struct DrawOp;
struct FastTexels;
struct SetupPrimitive;
struct TileDraw;
struct UnitOp;

/// The least and the greatest of a plane's values at the corners.
struct PlaneLimits {
    std::int32_t low = 0, high = 0;

    /// The plane at a pixel of the tile with an outer centre (R9.28).
    std::int64_t at(const TilePlane& p, int i, int j) const {
        const std::uint64_t v =
            p.c + std::uint64_t(p.gx) * std::uint64_t(i) + std::uint64_t(p.gy) * std::uint64_t(j);
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(v) >> 16, low, high);
    }
};

/// Colour and fog.
struct ColorPlanes {
    TilePlane color[4];  ///< numerators if `perspective`
    bool perspective = false;
    Rgba low{}, high{};       ///< of the corners, by channel
    bool has_limits = false;  ///< the following are set
    PlaneLimits limits[4], q_limits;
    TilePlane q;    ///< denominator, if colour or fog needs one
    TilePlane fog;  ///< factor, or numerator of the coordinate
    float fog_scale = 1;
};

/// The number of primitives that are set up together.
inline constexpr std::size_t batch_capacity = 16;

/// Triangles of a set by ordinal, a lane each; lanes from `count` to `filled` repeat the first.
struct Corners {
    std::size_t count = 0, filled = batch_capacity;
    int s = 3;
    bool smooth = false;  ///< antialiased: planes need limits (R9.28)
    std::uint32_t ordinal[batch_capacity];
    const SetupPrimitive* primitive[batch_capacity];
    alignas(64) std::int32_t x[3][batch_capacity], y[3][batch_capacity];  ///< jittered
    alignas(64) std::uint32_t z[3][batch_capacity];
    /// pixels from corner 0's to the tile
    alignas(64) std::int32_t to_x[batch_capacity], to_y[batch_capacity];
    alignas(64) double dx1[batch_capacity], dy1[batch_capacity], dx2[batch_capacity],
        dy2[batch_capacity], area2[batch_capacity];
    /// from corner 0 to the centre of its pixel
    alignas(64) double ax[batch_capacity], ay[batch_capacity];
};

/// Planes of at most 16 bits, modulo 2^32, of a batch: R, G, B, A and the fog factor at the
/// vertices.
struct NarrowBatch {
    alignas(64) std::uint32_t c[5][batch_capacity], gx[5][batch_capacity], gy[5][batch_capacity];
    /// triangles known to have R, G and B 0 at all vertices, a bit each
    std::uint32_t black = 0;
};

/// A given fog coordinate, whose factor is found lane by lane.
struct GivenFog {
    TilePlane numerator, q;
    double offset = 0;
    int exponent = 0;
};

/// A block's texture coordinates after the division, each lane of its own primitive.
struct TextureLanes {
    alignas(64) float u[block_pixels], v[block_pixels];  ///< U / Q 2^e
    alignas(64) float rho[block_pixels];
    alignas(64) std::int32_t u_k[block_pixels], v_k[block_pixels];
};

/// A texture coordinate: numerator / q * 2^exponent + k.
struct TexturePlane {
    TilePlane plane;
    int exponent = 0;
    std::int32_t k = 0;  ///< 0 under Repeat
    CoordinateSlope slope;
    PlaneSlope plane_slope;  ///< of textures with r
    PlaneLimits limits;      ///< if TexturePlanes::has_limits
};

struct TexturePlanes {
    TilePlane q;
    TexturePlane s, t, r;
    int slope_x = 0, slope_y = 0;  ///< window pixel that the slopes are given at
    PlaneSlope q_slope;            ///< of textures with r
    bool has_limits = false;
    PlaneLimits q_limits;
    std::vector<TexturePlanes> more;  ///< of units 1 to 3, if the draw has several
};

/// Fragments of several blocks, whose texels are looked up together: lanes that lie side by side,
/// and the blocks that they belong to, in order.
struct TexelQueue {
    static constexpr std::size_t capacity = 128;
    struct Block {
        std::uint8_t triangle, x, y;
        std::uint16_t lanes;
    };
    std::size_t lanes = 0, count = 0;
    Block blocks[capacity];
    std::bitset<max_tile_blocks> waiting;  ///< those in `blocks`, 16 in a row
    // as in TextureLanes, with room for a vector
    alignas(64) float u[capacity + block_pixels], v[capacity + block_pixels],
        rho[capacity + block_pixels];
    alignas(64) std::int32_t u_k[capacity + block_pixels], v_k[capacity + block_pixels];
};

/// Blocks all of whose pixels have one value, as of the uniform blocks read last.
struct FilledBlocks {
    ColorBlock color{};
    DepthBlock depth{};

    const ColorBlock& of_color(const Rgba& value) {
        for (std::size_t c = 0; c < 4; ++c)
            if (color.channel[c][0] != value[c])
                std::fill(std::begin(color.channel[c]), std::end(color.channel[c]), value[c]);
        return color;
    }
    const DepthBlock& of_depth(std::uint32_t value) {
        if (depth.value[0] != value)
            std::fill(std::begin(depth.value), std::end(depth.value), value);
        return depth;
    }
};

/// A batch's planes while it is drawn; each worker thread has one scratch.
struct BatchScratch {
    FilledBlocks filled;
    ColorPlanes color[batch_capacity], secondary[batch_capacity];
    GivenFog fog[batch_capacity];
    TexturePlanes texture[batch_capacity];
    TexelQueue queue;
};

DepthPlane depth_plane(const TileDraw& draw, const SetupPrimitive& primitive,
                       const PrimitiveFrame& frame);
void make_color_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                       const PrimitiveFrame& frame, ColorPlanes& out);
/// Of a draw that sums colours: R, G, B.
void make_secondary_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                           const PrimitiveFrame& frame, ColorPlanes& out);
/// Of a draw with direct_fog.
GivenFog given_fog(const TileDraw& draw, const SetupPrimitive& primitive,
                   const PrimitiveFrame& frame);
/// A primitive's colours at single places, before texture. The frame is any that has no place.
struct OuterColors {
    static bool applies_to(const DrawOp& op, const SetupPrimitive& primitive);
    OuterColors(const TileDraw& draw, const SetupPrimitive& primitive, const PrimitiveFrame& frame);
    /// At the place of a frame.
    Rgba at(const PrimitiveFrame& frame) const;

    bool perspective = false, constant = false;
    Rgba low{}, high{};                 ///< of the vertices; `low` is the one colour
    std::array<LimitedPlane, 4> color;  ///< numerators if `perspective`
    LimitedPlane q;
    float one = 255;
};
/// The texture coordinates of one unit at pixels with outer centres.
struct OuterCoordinates {
    LimitedPlane q, s, t, r;
    bool below_q = false;  ///< s and t are at most q
};
/// A primitive's texture coordinates at pixels with outer centres.
class OuterTextures {
public:
    /// Sets nothing up if the draw is not textured.
    OuterTextures(const TileDraw& draw, const SetupPrimitive& primitive,
                  const PrimitiveFrame& frame);
    /// At the place of a frame with an outer centre.
    const TexturePlanes& at(const PrimitiveFrame& frame);

private:
    TexturePlanes planes_;
    std::array<OuterCoordinates, max_texture_units> units_;
};
/// The size of a point.
float point_size_of(const TileDraw& draw, const SetupPrimitive& primitive);
/// The colour of a primitive's identifier.
Rgba id_color(const TileDraw& draw, const SetupPrimitive& primitive);
void make_texture_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                         const PrimitiveFrame& frame, TexturePlanes& out);

/// The fog factors of the lanes of `mask` in block (bx, by), one by one.
void find_given_fog(const GivenFog& fog, const TileDraw& draw, int bx, int by, std::uint32_t mask,
                    std::uint32_t* factor);

/// The texels of a block, by unit.
using TexelBlocks = std::array<ColorBlock, max_texture_units>;
/// A unit's denominators and numerators at the pixels of a block; r of textures with r and of
/// comparisons only.
struct TexelValues {
    alignas(64) std::int32_t q[block_pixels], s[block_pixels], t[block_pixels], r[block_pixels];
};
/// Lanes of `mask` in block (bx, by), one by one, of one unit.
void sample_by_pixel(const TexturePlanes& planes, const TexelValues& values, const TileDraw& draw,
                     std::size_t unit, const UnitOp& op, int bx, int by, std::uint32_t mask,
                     ColorBlock& out);

/// A block's texels whose depths are compared, and r as a float scaled to depths.
struct ComparedLanes {
    alignas(64) std::int32_t i[block_pixels], j[block_pixels];  ///< before they wrap
    alignas(64) float r[block_pixels];
    std::uint32_t outside = 0;  ///< lanes with q below 1, which are lit
};
/// The comparisons of the lanes of `mask`.
void compare_depths(const ComparedLanes& lanes, const TileDraw& draw, std::size_t unit,
                    const FastTexels& texels, std::uint32_t mask, ColorBlock& out);
/// The environments of a draw's units in turn.
void apply_units(const TileDraw& draw, const ColorBlock& color, const TexelBlocks& texels,
                 ColorBlock& out);

}  // namespace gw::fast
