// Linear functions over the blocks of a tile, evaluated at one block, then stepped from block to
// block and row to row by additions modulo 2^32. Increments equal the closed form; docs/manual.md,
// "Planes". Does not know the meaning of the values. Included once per Highway target.
#if defined(GW_FAST_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_WALK_INL_H_
#undef GW_FAST_WALK_INL_H_
#else
#define GW_FAST_WALK_INL_H_
#endif

#include "gw/fast/simd/planes-inl.h"

// The work on a block is inlined into each loop over blocks. With 128-bit vectors its code is four
// times as long; calling it instead halves compile time.
#undef GW_PER_BLOCK
#if HWY_MAX_BYTES >= 32
#define GW_PER_BLOCK HWY_INLINE
#else
#define GW_PER_BLOCK HWY_NOINLINE
#endif

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The number of vectors that a block's 16 lanes fill.
inline constexpr std::size_t parts = block_pixels / lanes32;

/// A subset of a block's lanes.
struct LaneSet {
    M32 part[parts];

    HWY_INLINE bool none() const {
#if HWY_TARGET == HWY_WASM  // a test of a mask costs more than joining two
        M32 any = part[0];
        for (std::size_t i = 1; i < parts; ++i) any = hn::Or(any, part[i]);
        return hn::AllFalse(D32(), any);
#else  // the tests share their bits with bits()
        bool empty = true;
        for (std::size_t i = 0; i < parts; ++i) empty = empty && hn::AllFalse(D32(), part[i]);
        return empty;
#endif
    }
    HWY_INLINE std::uint32_t bits() const {
#if HWY_TARGET == HWY_WASM  // narrowed to one vector, a byte a lane
        return wasm_i8x16_bitmask(
            wasm_i8x16_narrow_i16x8(wasm_i16x8_narrow_i32x4(part[0].raw, part[1].raw),
                                    wasm_i16x8_narrow_i32x4(part[2].raw, part[3].raw)));
#else
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < parts; ++i)
            mask |= bits_of(D32(), part[i], lanes32) << (i * lanes32);
        return mask;
#endif
    }
};

/// All of a block's lanes, known at compile time.
struct AllLanes {};

/// The lanes of a part that are in the set.
HWY_INLINE M32 among(const LaneSet& lanes, std::size_t part, M32 mask) {
    return hn::And(lanes.part[part], mask);
}
HWY_INLINE M32 among(AllLanes, std::size_t, M32 mask) { return mask; }

HWY_INLINE LaneSet lane_set(std::uint32_t mask) {
    LaneSet s;
    for (std::size_t i = 0; i < parts; ++i) s.part[i] = lanes_of(D32(), mask, i * lanes32);
    return s;
}

/// Whether one of the lanes of `mask` is in a part. A triangle's edge leaves many parts empty.
HWY_INLINE bool has_part(std::uint32_t mask, std::size_t part) {
    if constexpr (parts == 1) return true;
    constexpr std::uint32_t lanes = (1u << lanes32 % block_pixels) - 1;
    return (mask >> (part * lanes32) & lanes) != 0;
}

/// Counts how often each lane was in a set. Blocks with all lanes are counted separately.
struct LaneCounter {
    V32 count[parts];
    std::uint64_t whole = 0;

    HWY_INLINE void clear() {
        whole = 0;
        for (auto& part : count) part = hn::Zero(D32());
    }
    HWY_INLINE void add(const LaneSet& s) {
        for (std::size_t i = 0; i < parts; ++i)
#if HWY_TARGET == HWY_WASM  // a lane of the mask is 0 or -1
            count[i] = hn::Sub(count[i], hn::VecFromMask(D32(), s.part[i]));
#else
            count[i] = hn::IfThenElse(s.part[i], hn::Add(count[i], hn::Set(D32(), 1u)), count[i]);
#endif
    }
    HWY_INLINE void add(AllLanes) { whole += 1; }
    HWY_INLINE void add(const LaneCounter& other) {
        whole += other.whole;
        for (std::size_t i = 0; i < parts; ++i) count[i] = hn::Add(count[i], other.count[i]);
    }
    HWY_INLINE std::uint64_t total() const {
        alignas(64) std::uint32_t lane[block_pixels];
        for (std::size_t i = 0; i < parts; ++i) hn::Store(count[i], D32(), lane + i * lanes32);
        std::uint64_t sum = whole * block_pixels;
        for (const std::uint32_t n : lane) sum += n;
        return sum;
    }
};

/// A value of at most 16 bits on a whole block: put(part, values), from the lowest rows up.
template <class Put>
HWY_INLINE void narrow_block(std::uint32_t c, std::uint32_t gx, std::uint32_t gy, int bx, int by,
                             const Put& put) {
    const D32 d;
    const auto all_c = hn::Set(d, c), all_gx = hn::Set(d, gx), all_gy = hn::Set(d, gy);
    if constexpr (lanes32 < block_side) {
        for (std::size_t part = 0; part < parts; ++part)
            put(part, narrow_value(all_c, all_gx, all_gy, pixels_of(bx, by, part * lanes32)));
        return;
    }
    const Pixels lowest = pixels_of(bx, by, 0);
    auto sum = hn::Add(hn::Add(all_c, hn::Mul(all_gx, lowest.x)), hn::Mul(all_gy, lowest.y));
    const auto up = hn::Set(d, gy * std::uint32_t(lanes32 / block_side));
    for (std::size_t part = 0; part < parts; ++part, sum = hn::Add(sum, up))
        put(part, hn::ShiftRight<16>(sum));
}

/// c + gx i + gy j, modulo 2^32, at any block.
struct LinearLanes {
    std::uint32_t c, gx, gy;
    V32 lane[parts];

    HWY_INLINE void aim(std::uint32_t c_, std::uint32_t gx_, std::uint32_t gy_) {
        const D32 d;
        c = c_;
        gx = gx_;
        gy = gy_;
        const auto x = hn::Set(d, gx), y = hn::Set(d, gy);
        for (std::size_t i = 0; i < parts; ++i)
            lane[i] = hn::Add(hn::Mul(x, hn::Load(d, lane_x + i * lanes32)),
                              hn::Mul(y, hn::Load(d, lane_y + i * lanes32)));
    }
    /// At the block's lowest pixel.
    HWY_INLINE std::uint32_t corner(int bx, int by) const {
        return c + gx * std::uint32_t(bx * block_side) + gy * std::uint32_t(by * block_side);
    }
    HWY_INLINE V32 above(std::uint32_t corner_value, std::size_t part) const {
        return hn::Add(hn::Set(D32(), corner_value), lane[part]);
    }
    HWY_INLINE V32 at(int bx, int by, std::size_t part) const {
        return above(corner(bx, by), part);
    }
};

/// The same function at a moving block. aim() sets the function, start() the block; next_block()
/// and next_row() step through a range.
struct Linear {
#if HWY_MAX_BYTES >= 32
    LinearLanes lanes;
    V32 now[parts], row[parts], right, up;

    HWY_INLINE void aim(std::uint32_t c, std::uint32_t gx, std::uint32_t gy) {
        const D32 d;
        lanes.aim(c, gx, gy);
        right = hn::Set(d, gx * std::uint32_t(block_side));
        up = hn::Set(d, gy * std::uint32_t(block_side));
    }
    HWY_INLINE void start(int bx, int by) {
        for (std::size_t i = 0; i < parts; ++i) now[i] = lanes.at(bx, by, i);
    }
    HWY_INLINE void start_rows(int bx, int by) {
        for (std::size_t i = 0; i < parts; ++i) now[i] = row[i] = lanes.at(bx, by, i);
    }
    HWY_INLINE void next_block() {
        for (auto& part : now) part = hn::Add(part, right);
    }
    HWY_INLINE void next_row() {
        for (std::size_t i = 0; i < parts; ++i) now[i] = row[i] = hn::Add(row[i], up);
    }
    HWY_INLINE V32 at(std::size_t part) const { return now[part]; }
#else  // four vectors a block: stepping its lowest pixel costs less
    LinearLanes lanes;
    std::uint32_t now, row;

    HWY_INLINE void aim(std::uint32_t c, std::uint32_t gx, std::uint32_t gy) {
        lanes.aim(c, gx, gy);
    }
    HWY_INLINE void start(int bx, int by) { now = lanes.corner(bx, by); }
    HWY_INLINE void start_rows(int bx, int by) { now = row = lanes.corner(bx, by); }
    HWY_INLINE void next_block() { now += lanes.gx * std::uint32_t(block_side); }
    HWY_INLINE void next_row() { now = row += lanes.gy * std::uint32_t(block_side); }
    HWY_INLINE V32 at(std::size_t part) const { return lanes.above(now, part); }
#endif
};

/// A value of up to 32 bits, as in wide_plane(), in two halves that are each linear.
template <class Half>
struct WideHalves {
    Half high, low;

    HWY_INLINE void aim(const TilePlane& p) {
        const auto upper = [](std::int64_t v) { return std::uint32_t(v >> 16); };
        const auto lower = [](std::int64_t v) { return std::uint32_t(v & 0xFFFF); };
        high.aim(upper(std::int64_t(p.c)), upper(p.gx), upper(p.gy));
        low.aim(lower(std::int64_t(p.c)), lower(p.gx), lower(p.gy));
    }
};
struct WidePlaneLanes : WideHalves<LinearLanes> {
    /// The halves at a block's lowest pixel.
    struct Corner {
        std::uint32_t high, low;
    };
    HWY_INLINE Corner corner(int bx, int by) const {
        return {high.corner(bx, by), low.corner(bx, by)};
    }
    HWY_INLINE V32 above(Corner corner, std::size_t part) const {
        return hn::Add(high.above(corner.high, part),
                       hn::ShiftRight<16>(low.above(corner.low, part)));
    }
    HWY_INLINE V32 at(int bx, int by, std::size_t part) const {
        return above(corner(bx, by), part);
    }
};
struct WidePlaneWalk : WideHalves<Linear> {
    HWY_INLINE void start(int bx, int by) { high.start(bx, by), low.start(bx, by); }
    HWY_INLINE void start_rows(int bx, int by) { high.start_rows(bx, by), low.start_rows(bx, by); }
    HWY_INLINE void next_block() { high.next_block(), low.next_block(); }
    HWY_INLINE void next_row() { high.next_row(), low.next_row(); }
    HWY_INLINE V32 at(std::size_t part) const {
        return hn::Add(high.at(part), hn::ShiftRight<16>(low.at(part)));
    }
};

/// A triangle's depth, moving with the blocks that it covers.
struct DepthWalk {
    const DepthPlane& plane;
    std::uint32_t max_depth;
    WidePlaneWalk walk;  ///< not set before aim()

    HWY_INLINE explicit DepthWalk(const DepthPlane& p, std::uint32_t max = 0)
        : plane(p), max_depth(max) {}
    HWY_INLINE void aim() { walk.aim(plane.plane); }
    HWY_INLINE void start(int bx, int by) { walk.start(bx, by); }
    HWY_INLINE void start_rows(int bx, int by) { walk.start_rows(bx, by); }
    HWY_INLINE void next_block() { walk.next_block(); }
    HWY_INLINE void next_row() { walk.next_row(); }
    HWY_INLINE void store(DepthBlock& out) const {
        for (std::size_t i = 0; i < parts; ++i)
            hn::Store(walk.at(i), D32(), out.value + i * lanes32);
        if (plane.offset != 0) offset_depths(plane.offset, max_depth, out);
    }
};

/// A walk with nothing to evaluate.
struct NullWalk {
    HWY_INLINE void aim() {}
    HWY_INLINE void start(int, int) {}
    HWY_INLINE void start_rows(int, int) {}
    HWY_INLINE void next_block() {}
    HWY_INLINE void next_row() {}
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
