// Texels of several blocks, looked up together: small triangles have few fragments in a block.
// Colours, texture environment and writing follow block by block, in order. docs/manual.md,
// "Textures"; scalar twin: gw/reference/texture_unit.cpp. Does not test. Included once per Highway
// target.
#if defined(GW_FAST_TEXEL_QUEUE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TEXEL_QUEUE_INL_H_
#undef GW_FAST_TEXEL_QUEUE_INL_H_
#else
#define GW_FAST_TEXEL_QUEUE_INL_H_
#endif

#include "gw/fast/fragments/blend-inl.h"
#include "gw/fast/shade/batch-inl.h"
#include "gw/fast/simd/pack_lanes-inl.h"

#include <algorithm>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE std::size_t queue_place(int bx, int by) {
    return std::size_t(by) * 16 + std::size_t(bx);
}

/// Whether a block's fragments wait: they fill few lanes, or others of the block wait already.
HWY_INLINE bool waits(const TexelQueue* queue, int bx, int by, std::uint32_t alive) {
    constexpr int most_lanes = 11;
    return queue &&
           (std::popcount(alive) <= most_lanes || queue->waiting.test(queue_place(bx, by)));
}

/// Draws the fragments that wait.
HWY_NOINLINE inline void draw_waiting(BatchPlanes& planes) {
    TexelQueue& q = *planes.queue;
    const TileDraw& draw = planes.draw;
    const Sampler sampler = sampler_of(*draw.op);
    alignas(64) std::uint16_t texels[4][TexelQueue::capacity + block_pixels];
    ColorBlock found;
    for (std::size_t n = q.lanes; n % block_pixels != 0; ++n) {
        q.u[n] = q.v[n] = q.rho[n] = 0;
        q.u_k[n] = q.v_k[n] = 0;
    }
    for (std::size_t n = 0; n < q.lanes; n += block_pixels) {
        sample_lanes(sampler, {q.u + n, q.v + n, q.rho + n, q.u_k + n, q.v_k + n}, all_lanes,
                     found);
        for (std::size_t c = 0; c < 4; ++c)
            std::memcpy(texels[c] + n, found.channel[c], sizeof found.channel[c]);
    }
    std::size_t n = 0;
    for (std::size_t k = 0; k < q.count; ++k) {
        const TexelQueue::Block& b = q.blocks[k];
        for (std::size_t c = 0; c < 4; ++c)
            spread_lanes(texels[c] + n, b.lanes, planes.in.texels[0].channel[c]);
        n += std::size_t(std::popcount(b.lanes));
        write_color(draw.op->state, planes.textured_color(b.triangle, b.x, b.y, b.lanes),
                    draw.tile.color[draw.tile.block(b.x, b.y)], b.lanes);
    }
    q.lanes = q.count = 0;
    q.waiting.reset();
}

/// Lets a block's fragments of triangle i of the batch wait for their texels.
HWY_NOINLINE inline void let_wait(BatchPlanes& planes, std::size_t i, int bx, int by,
                                  std::uint32_t alive) {
    TexelQueue& q = *planes.queue;
    if (q.lanes + block_pixels > TexelQueue::capacity) draw_waiting(planes);
    planes.make();
    TextureLanes& at = planes.in.divided;
    const TexturePlanes& texture = planes.scratch.texture[i];
    divide_block(sampler_of(*planes.draw.op), texture, planes.draw.tile, bx, by, alive, at);
    pack_parts(alive, [&](std::size_t first, const std::uint8_t* order, std::size_t to) {
        to += q.lanes;
        store_packed(at.u + first, order, q.u + to);
        store_packed(at.v + first, order, q.v + to);
        store_packed(at.rho + first, order, q.rho + to);
        std::fill_n(q.u_k + to, packed_lanes, texture.s.k);
        std::fill_n(q.v_k + to, packed_lanes, texture.t.k);
    });
    q.lanes += std::size_t(std::popcount(alive));
    q.blocks[q.count++] = {std::uint8_t(i), std::uint8_t(bx), std::uint8_t(by),
                           std::uint16_t(alive)};
    q.waiting.set(queue_place(bx, by));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
