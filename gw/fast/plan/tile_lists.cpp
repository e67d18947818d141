// Lists for each tile the operations that may change or read any of its pixels.
#include "gw/fast/plan/plan.h"
#include "gw/stages/tables.h"

#include <algorithm>

namespace gw::fast {
namespace {

/// Calls visit(tile) for each tile that an operation may touch.
template <class Visit>
struct ForEachTile {
    const TileGrid& grid;
    const Visit& visit;

    void operator()(const DrawOp& op) const {
        const PartGroup& group = *op.group;
        const TileRange box = range_of(op.state.draw_box), all = group.tiles;
        const TileRange tiles{std::max(all.x0, box.x0), std::max(all.y0, box.y0),
                              std::min(all.x1, box.x1), std::min(all.y1, box.y1)};
        for (int row = tiles.y0; row < tiles.y1; ++row)
            for (int column = tiles.x0; column < tiles.x1; ++column)
                if (all.count() == 1 || !group.tile_bin(column, row).empty())
                    visit(tile(column, row));
    }
    void operator()(const ClearOp& op) const { in_box(op.state.pixel_box); }
    void operator()(const SpansOp& op) const { in_box(op.state.pixel_box); }
    void operator()(const PixelsOp& op) const {
        in_box(intersect(op.state.pixel_box, op.write->rect));
    }
    void operator()(const DrawPixelsOp& op) const { in_box(op.placed->box()); }
    void operator()(const AccumulateOp& op) const { in_box(op.state.pixel_box); }
    void operator()(const ReadOp& op) const { in_box(op.read->rect); }

private:
    std::size_t tile(int column, int row) const {
        return std::size_t(row) * std::size_t(grid.columns()) + std::size_t(column);
    }
    /// The tiles of a rectangle inside the window.
    TileRange range_of(const Rect& box) const {
        if (box.width <= 0 || box.height <= 0) return {};
        const auto last = [&](int first, int size) {
            return std::uint16_t(((first + size - 1) >> grid.log2_tile) + 1);
        };
        return {std::uint16_t(box.x >> grid.log2_tile), std::uint16_t(box.y >> grid.log2_tile),
                last(box.x, box.width), last(box.y, box.height)};
    }
    void in_box(const Rect& box) const {
        const TileRange tiles = range_of(box);
        for (int row = tiles.y0; row < tiles.y1; ++row)
            for (int column = tiles.x0; column < tiles.x1; ++column) visit(tile(column, row));
    }
};

/// Whether the counts of two operations add the same to the same pass.
bool counts_alike(const TileOp& a, const TileOp& b) {
    const DrawOp *p = std::get_if<DrawOp>(&a.op), *q = std::get_if<DrawOp>(&b.op);
    if (!p || !q || a.pass != b.pass) return false;
    return p->bytes.after_alpha == q->bytes.after_alpha &&
           p->bytes.after_stencil == q->bytes.after_stencil &&
           p->bytes.written == q->bytes.written && p->look_ups == q->look_ups;
}

void give_count_slots(Segment& segment) {
    constexpr std::size_t looked_at = 4;
    for (std::uint32_t i = 0; i < segment.ops.size(); ++i) {
        TileOp& op = segment.ops[i];
        std::vector<std::uint32_t>& slots = segment.count_slots;
        const std::size_t first = slots.size() - std::min(slots.size(), looked_at);
        std::size_t slot = first;
        while (slot < slots.size() && !counts_alike(segment.ops[slots[slot]], op)) ++slot;
        if (slot == slots.size()) slots.push_back(i);
        op.count_slot = std::uint32_t(slot);
    }
}

}  // namespace

void list_by_tile(Segment& segment, const TileGrid& grid) {
    give_count_slots(segment);
    std::vector<std::uint32_t> count(grid.count());
    const auto for_each = [&](const TileOp& op, const auto& visit) {
        std::visit(ForEachTile<std::decay_t<decltype(visit)>>{grid, visit}, op.op);
    };
    for (const TileOp& op : segment.ops) for_each(op, [&](std::size_t tile) { count[tile] += 1; });
    std::uint32_t sum = 0;
    for (std::uint32_t tile = 0; tile < count.size(); ++tile) {
        if (count[tile] == 0) continue;
        segment.tiles.push_back(tile);
        segment.tile_start.push_back(sum);
        sum += count[tile];
        count[tile] = segment.tile_start.back();
    }
    segment.tile_start.push_back(sum);
    segment.tile_ops.resize(sum);
    for (std::uint32_t i = 0; i < segment.ops.size(); ++i)
        for_each(segment.ops[i], [&](std::size_t tile) { segment.tile_ops[count[tile]++] = i; });
}

}  // namespace gw::fast
