// The pixels that a triangle on a few blocks covers, as bits. docs/manual.md, "Coverage"; scalar
// twin: gw/reference/coverage.cpp. Does not test or paint. Included once per Highway target.
#if defined(GW_FAST_COVERED_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COVERED_BLOCKS_INL_H_
#undef GW_FAST_COVERED_BLOCKS_INL_H_
#else
#define GW_FAST_COVERED_BLOCKS_INL_H_
#endif

#include "gw/fast/raster/cover-inl.h"

#include <algorithm>
#include <bit>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

alignas(64) inline constexpr std::int16_t short_lane_x[16] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                              0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr std::int16_t short_lane_y[16] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                              2, 2, 2, 2, 3, 3, 3, 3};

/// In 4x4 blocks the value of an edge with short gradients changes by less than short_limit, and
/// both together fit 16 bits.
inline constexpr int short_most = 512, short_limit = 16000;
static_assert(2 * short_most * (4 * block_side - 1) < short_limit && 2 * short_limit < 1 << 15);

HWY_INLINE bool has_short_edges(const TileEdges& e) {
    const auto is_short = [](int v) { return std::uint32_t(v + short_most) <= 2 * short_most; };
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) count += int{is_short(e.a[k])} + int{is_short(e.b[k])};
    return count == 6;
}

/// A short edge's values, 16 bits a pixel, in 4x4 blocks from (x, y) on. Where the value at the
/// lowest pixel is limited, its sign is the same in all of them.
struct ShortEdge {
    using D = hn::RebindToSigned<D16>;
    static constexpr std::size_t vectors = block_pixels / lanes16;
    hn::Vec<D> now[vectors], row[vectors], right, up;

    HWY_INLINE ShortEdge(const TileEdges& e, std::size_t k, int x, int y) {
        const D d;
        const auto all = [&](int v) { return hn::Set(d, static_cast<std::int16_t>(v)); };
        const int corner = e.c[k] + block_side * (e.a[k] * x + e.b[k] * y);
        const auto a = all(e.a[k]), b = all(e.b[k]),
                   lowest = all(std::clamp(corner, -short_limit, short_limit));
        for (std::size_t i = 0; i < vectors; ++i) {
            const auto across = hn::Mul(a, hn::Load(d, short_lane_x + i * lanes16)),
                       along = hn::Mul(b, hn::Load(d, short_lane_y + i * lanes16));
            now[i] = row[i] = hn::Add(lowest, hn::Add(across, along));
        }
        right = hn::ShiftLeft<2>(a);
        up = hn::ShiftLeft<2>(b);
    }
    HWY_INLINE void next_block() {
        for (auto& vector : now) vector = hn::Add(vector, right);
    }
    HWY_INLINE void next_row() {
        for (std::size_t i = 0; i < vectors; ++i) now[i] = row[i] = hn::Add(row[i], up);
    }
};
/// The lanes of a block that are outside any of three edges.
HWY_INLINE std::uint32_t outside(const ShortEdge& a, const ShortEdge& b, const ShortEdge& c) {
    const ShortEdge::D d;
    std::uint32_t lanes = 0;
    for (std::size_t i = 0; i < ShortEdge::vectors; ++i) {
        const auto any = hn::Or(hn::Or(a.now[i], b.now[i]), c.now[i]);
        lanes |= bits_of(d, hn::Lt(any, hn::Zero(d)), lanes16) << (i * lanes16);
    }
    return lanes;
}

/// Both classes call visit(bx, by, lanes) for each block that triangle i of a batch covers in part.
/// It touches at most 2x2 blocks here.
class SmallBlocks {
public:
    HWY_INLINE SmallBlocks(const BoxLanes& box, const Triangles& t, std::size_t i)
        : box_(box), x_(t.x0[i] / block_side), y_(t.y0[i] / block_side), lanes_(t.small_lanes(i)) {}

    template <class Visit>
    HWY_INLINE void visit(Visit& visit) const {
        for (std::uint64_t rest = lanes_; rest != 0;) {
            const int first = std::countr_zero(rest) & ~15, block = first / block_pixels;
            const int bx = x_ + block % 2, by = y_ + block / 2;
            const std::uint32_t lanes = std::uint32_t(rest >> first) & box_.mask(bx, by);
            rest &= ~(std::uint64_t{all_lanes} << first);
            if (lanes != 0) visit(bx, by, lanes);
        }
    }

private:
    const BoxLanes& box_;
    int x_, y_;
    std::uint64_t lanes_;  ///< as in Triangles
};

/// At most 4x4 blocks, of the range r.
class CoveredBlocks {
public:
    HWY_INLINE CoveredBlocks(const BoxLanes& box, const Triangles& t, std::size_t i,
                             const BlockRange& r)
        : CoveredBlocks(r) {
        const auto put = [&](int block, std::uint32_t lanes) { set(block, lanes); };
        const TileEdges edges = t.edges(i);
        if (has_short_edges(edges))
            find_short(edges, r, put);
        else
            find(edges, r);
        limit(box, r);
    }
    /// Of triangles i and i + 1, which have short edges, together.
    HWY_INLINE static CoveredBlocks of_two(const BoxLanes& box, const Triangles& t, std::size_t i,
                                           const BlockRange& r) {
        CoveredBlocks out(r);
        out.find_short(t.edges(i), r, [&](int block, std::uint32_t lanes) {
            out.lanes_[block] = std::uint16_t(lanes);
        });
        out.find_short(t.edges(i + 1), r, [&](int block, std::uint32_t lanes) {
            out.twice_ |= out.lanes_[block] & lanes;
            out.set(block, out.lanes_[block] | lanes);
        });
        out.limit(box, r);
        return out;
    }
    /// Whether two triangles cover a pixel twice.
    HWY_INLINE bool overlap() const { return twice_ != 0; }

    template <class Visit>
    HWY_INLINE void visit(Visit& visit) const {
        for (std::uint32_t rest = touched_; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            visit(x_ + i % group_blocks, y_ + i / group_blocks, std::uint32_t{lanes_[i]});
        }
    }

private:
    HWY_INLINE explicit CoveredBlocks(const BlockRange& r) : x_(r.x0), y_(r.y0) {}

    HWY_INLINE void set(int i, std::uint32_t lanes) {
        lanes_[i] = std::uint16_t(lanes);
        touched_ |= std::uint32_t{lanes != 0} << i;
    }
    HWY_NOINLINE void find(const TileEdges& edges, const BlockRange& r) {
        EdgeWalk edge;
        edge.aim(edges);
        edge.start_rows(x_, y_);
        for (int y = y_; y <= r.y1; ++y, edge.next_row())
            for (int x = x_; x <= r.x1; ++x, edge.next_block())
                set(group_blocks * (y - y_) + x - x_, edge.covered().bits());
    }
    template <class Put>
    HWY_INLINE void find_short(const TileEdges& e, const BlockRange& r, const Put& put) const {
        if (r.x1 - r.x0 < 3 && r.y1 - r.y0 < 3)
            find_short<3>(e, put);
        else
            find_short<4>(e, put);
    }
    /// Calls put(block, lanes) for side x side blocks.
    template <int side, class Put>
    HWY_INLINE void find_short(const TileEdges& e, const Put& put) const {
        ShortEdge e0(e, 0, x_, y_), e1(e, 1, x_, y_), e2(e, 2, x_, y_);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                put(group_blocks * y + x, outside(e0, e1, e2) ^ all_lanes);
                e0.next_block();
                e1.next_block();
                e2.next_block();
            }
            e0.next_row();
            e1.next_row();
            e2.next_row();
        }
    }
    /// Leaves only blocks of the range, and lanes of the box.
    HWY_INLINE void limit(const BoxLanes& box, const BlockRange& r) {
        touched_ &= (0xFu >> (3 - (r.x1 - x_))) * 0x1111u & 0xFFFFu >> (4 * (3 - (r.y1 - y_)));
        if (box.whole) return;
        for (std::uint32_t rest = std::exchange(touched_, 0); rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            set(i, lanes_[i] & box.mask(x_ + i % group_blocks, y_ + i / group_blocks));
        }
    }

    int x_, y_;
    std::uint32_t touched_ = 0, twice_ = 0;
    std::uint16_t lanes_[group_blocks * group_blocks];
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
